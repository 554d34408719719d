# The library behind decomposePar's method scotch (sourced, bash)
# Needs: lib/messages.sh, lib/apt.sh, lib/debianTree.sh
#
# Debian's libscotchDecomp.so is OpenFOAM's stand-in, which only stops with a
# message. The real one is built from the unpacked source and Debian's
# libscotch-dev into the library folder of the tree, which comes before the
# packaged libraries on the LD_LIBRARY_PATH of etc/bashrc.

# scotchMissing: is the packaged library the stand-in, without one in the tree?
scotchMissing()
{
    local built packaged
    for built in "$(debianTree)"/platforms/*/lib/libscotchDecomp.so
    do
        [ ! -e "$built" ] || return 1
    done
    packaged="$(dpkg -L libopenfoam | grep '/libscotchDecomp\.so$')"
    [ -z "$packaged" ] || ! ldd "${packaged%%[[:space:]]*}" \
        | grep -q '[[:space:]]libscotch-*[0-9.]*\.so'
}

# buildScotch: build it in a folder of its own, under another name that is
# renamed at the end
buildScotch()
{
    local tree cache lock
    tree="$(debianTree)"
    cache="$(debianCache)"
    exec {lock}> "$cache/lock"
    flock "$lock"
    if scotchMissing    # else: made by another process while we waited
    then
        note "building OpenFOAM's scotchDecomp in $cache"
        compileScotch "$tree" "$cache/scotch" > "$cache/scotch.log" 2>&1 || {
            tail -n 20 "$cache/scotch.log" 1>&2
            die "could not build libscotchDecomp.so in $tree"
        }
        rm -rf "$cache/scotch" "$cache/scotch.log"
    fi
    exec {lock}>&-
}

# compileScotch <tree> <work folder>
compileScotch()
{
    rm -rf "$2" && mkdir -p "$2/lib" || return
    cp -r "$1/src/parallel/decompose/scotchDecomp" "$2/scotchDecomp" || return
    env -i HOME="$HOME" PATH="$PATH" FOAM_CONFIG_MODE=o TREE="$1" WORK="$2" \
        bash -c '
        . "$TREE/etc/bashrc"
        target="$FOAM_LIBBIN"
        . "$TREE/etc/packaged.sh"
        libraries="$FOAM_LIBBIN"
        export FOAM_LIBBIN="$WORK/lib"
        export SCOTCH_INC_DIR="/usr/include/scotch-int$WM_LABEL_SIZE"
        SCOTCH_LIB_DIR="$(dpkg -L libscotch-dev \
            | grep "/scotch-int$WM_LABEL_SIZE/libscotch\.so$")"
        export SCOTCH_LIB_DIR="${SCOTCH_LIB_DIR%/*} -L$libraries"
        cd "$WORK/scotchDecomp" \
     && sed -i "s%\.\./decomp%$TREE/src/parallel/decompose/decomp%" \
            Make/options \
     && wmake libso \
     && mkdir -p "$target" \
     && mv "$WORK/lib/libscotchDecomp.so" "$target"
    '
}
