# Build tree (headers, wmake, RunFunctions) of Debian's openfoam package from
# its source package (sourced, bash)
# Needs: lib/messages.sh, lib/apt.sh, lib/debianTree.sh

# unpackOpenFOAM: prepare the tree, under another name that is renamed at the
# end, so that the final name only ever holds a complete tree. What an
# interrupted run has left is removed. Steps are chained with && because
# callers may have switched set -e off.
unpackOpenFOAM()
{
    local tree cache work version lock
    tree="$(debianTree)"
    cache="$(debianCache)"
    version="$(debianSourceVersion)"
    work="$cache/unfinished"

    mkdir -p "$cache" || die "cannot write to $cache"
    exec {lock}> "$cache/lock"
    flock "$lock"
    if [ ! -d "$tree" ]     # else: made by another process while we waited
    then
        note "preparing headers and wmake of openfoam $version in $cache"
        rm -rf "$work" && mkdir "$work" || die "cannot write to $cache"
        downloadSource openfoam "$version" "$work"
        aptLogged dpkg-source --no-check -x "$work"/openfoam_*.dsc "$work/tree" \
     && trimTree "$work/tree" \
     && packagedFolders > "$work/tree/etc/packaged.sh" \
     && buildTools "$work/tree" \
     && mv "$work/tree" "$tree" \
     && rm -rf "$work" \
     || die "could not prepare $tree"
    fi
    exec {lock}>&-
}

# trimTree <tree>: what differs from the package's own build
trimTree()
{
    # Not needed to build against, and large
    rm -rf "$1/tutorials" "$1/doc" || return

    # Debian's hardening flags cost a call of dpkg-buildflags per compiled
    # file, and add -g; OpenFOAM's own flags are the ones to use here
    sed -i 's/\$(shell dpkg-buildflags[^)]*)//' \
        "$1"/wmake/rules/General/Gcc/c "$1"/wmake/rules/General/Gcc/c++ \
        || return

    # Without this file OpenFOAM's etc/bashrc asks mpicc, which only
    # libopenmpi-dev has: nothing built here includes mpi.h
    echo 'export MPI_ARCH_PATH=/usr' > "$1/etc/config.sh/openmpi-system"
}

# packagedFolders: settings for the packaged libraries and applications,
# wherever this version of the package has them
packagedFolders()
{
    local library application
    library="$(dpkg -L libopenfoam | grep '/libOpenFOAM\.so$')" \
 && application="$(dpkg -L openfoam | grep '/bin/blockMesh$')" \
 || return

    echo "# Folders of the packaged libraries and applications"
    echo "export FOAM_LIBBIN=${library%/*}"
    echo "export FOAM_APPBIN=${application%/*}"
    echo 'case ":$PATH:" in (*":$FOAM_APPBIN:"*) ;;'
    echo '    (*) PATH="$FOAM_APPBIN:$PATH" ;; esac'

    # Only where the loader does not find them anyway
    if env -i ldd "$application" | grep -q 'libOpenFOAM\.so.*not found'
    then
        echo 'LD_LIBRARY_PATH="$FOAM_LIBBIN:$LD_LIBRARY_PATH"'
    fi
}

# buildTools <tree>: wmake's dependency scanner and the lnInclude folders
buildTools()
{
    env -i HOME="$HOME" PATH="$PATH" FOAM_CONFIG_MODE=o TREE="$1" bash -c '
        . "$TREE/etc/bashrc" \
     && "$TREE/wmake/src/Allmake" \
     && wmakeLnIncludeAll -j "$TREE/src"
    ' > "$1/../tools.log" 2>&1 || {
        tail -n 20 "$1/../tools.log" 1>&2
        return 1
    }
}
