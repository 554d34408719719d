# Where the OpenFOAM build tree of the Debian package lives (sourced, bash)
#
# Debian's openfoam holds binaries and libraries only. Headers, wmake and
# RunFunctions are in its source package, which etc/setup unpacks into a cache
# folder named after the version; it exists only when it is complete.

# Raised when etc/setup prepares the tree differently: older trees are redone
debianTreeLevel=1

# debianSourceVersion: source version of the installed package, or empty
debianSourceVersion()
{
    local status
    status="$(dpkg-query -W -f '${db:Status-Abbrev}${source:Version}' \
        openfoam 2>/dev/null)" || return 0
    case "$status" in
        (?i*) echo "${status#???}" ;;
    esac
}

# debianCache: folder outside the repository for everything unpacked
debianCache()
{
    echo "${XDG_CACHE_HOME:-${HOME:?}/.cache}/shockShellFoam"
}

# debianTree: the build tree of the installed package, empty if not installed
debianTree()
{
    local version
    version="$(debianSourceVersion)"
    [ -z "$version" ] \
 || echo "$(debianCache)/openfoam-$version-setup$debianTreeLevel"
}
