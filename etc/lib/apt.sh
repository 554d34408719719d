# Debian/Ubuntu packages and their sources through apt (sourced, bash)
# Needs: SHOCKSHELL_DIR, lib/messages.sh

# partPackages <part> ...: their packages in etc/packages
partPackages()
{
    local part
    for part
    do
        sed -n "s/^$part  *\([^ #]*\).*/\1/p" "$SHOCKSHELL_DIR/etc/packages"
    done
}

# missingPackages <package> ...: those that are not installed
missingPackages()
{
    local package
    for package
    do
        case "$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null)"
        in
            (?i*) ;;
            (*) echo "$package" ;;
        esac
    done | sort -u
}

# installPackages <package> ...: with apt-get, as root
installPackages()
{
    local install="apt-get install -y --no-install-recommends $*"

    [ "$(id -u)" -eq 0 ] || die "missing packages: $*; run as root:" \
        "apt-get update && $install"

    note "installing $*"
    # A third-party entry may be out of reach; the installation decides
    aptLogged apt-get update || note "apt-get update failed, trying without"
    DEBIAN_FRONTEND=noninteractive \
        aptLogged $install -o DPkg::Lock::Timeout=600 \
        || die "could not install $*"
}

# aptLogged <command> ...: quiet unless it fails
aptLogged()
{
    local log status=0
    log="$(mktemp)"
    "$@" < /dev/null > "$log" 2>&1 || status=$?
    [ "$status" -eq 0 ] || tail -n 20 "$log" 1>&2
    rm -f "$log"
    return "$status"
}

# sourceEntries <apt folder> <folder>: the apt entries of the first, in both
# formats, turned from deb into deb-src and written to the second
sourceEntries()
{
    local file
    mkdir -p "$2"

    for file in "$1"/sources.list "$1"/sources.list.d/*.list
    do
        [ -f "$file" ] || continue
        sed -n '/^ *deb .*cdrom:/d; s/^ *deb\([[:space:]]\)/deb-src\1/p' \
            "$file" > "$2/${file##*/}.list"
    done

    for file in "$1"/sources.list.d/*.sources
    do
        [ -f "$file" ] || continue
        sed 's/^Types:.*/Types: deb-src/' "$file" > "$2/${file##*/}"
    done
}

# downloadSource <package> <version> <folder>: its source archive. All apt
# state is private to <folder>: the system's lists and settings stay as they are
downloadSource()
{
    local package="$1" version="$2" work="$3" log="$3/apt.log"
    mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
    sourceEntries /etc/apt "$work/sources"

    local -a apt=(
        apt-get
        -o Dir::Etc::sourcelist=/dev/null
        -o Dir::Etc::sourceparts="$work/sources"
        -o Dir::State::lists="$work/lists"
        -o Dir::Cache="$work/cache"
        -o APT::Sandbox::User=root
    )

    # A third-party entry without sources may fail here; the download decides
    "${apt[@]}" update > "$log" 2>&1 || true

    (
        cd "$work" \
     && "${apt[@]}" source --only-source --download-only "$package=$version"
    ) >> "$log" 2>&1 || {
        tail -n 20 "$log" 1>&2
        die "the apt entries of this machine offer no source of" \
            "$package $version; upgrade $package to the version they offer"
    }
}
