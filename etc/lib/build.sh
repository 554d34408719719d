# Building with wmake (sourced, bash; needs the environment of etc/bashrc)
# Needs: lib/messages.sh

# wmakeFolders <folder>: the folders below it that wmake can build, sorted
wmakeFolders()
{
    find "$1" -path '*/Make/files' 2> /dev/null \
        | sed 's%/Make/files$%%' | LC_ALL=C sort
}

# wmakeFolder <folder>: build it; stops with the folder's name if it fails.
# Prints nothing but "wmake <folder>" when everything in it is up to date.
wmakeFolder()
{
    removeStale "$1"
    wmake -s "$1" || die "$1 did not build"
}

# removeStale <folder>: what wmake itself does not notice
removeStale()
{
    local folder="$1" objects="$1/Make/$WM_OPTIONS" target
    [ -d "$objects" ] || return 0

    # A dependency file that names a deleted header stops make for good
    find "$objects" -name '*.dep' | while read -r dep
    do
        [ -z "$(cd "$folder" && missingHeaders "${dep#"$folder"/}")" ] \
            || rm -f "$dep"
    done

    # Links to headers are only made when Make/files has changed
    if grep -q '^ *LIB *=' "$folder/Make/files" && newHeaders "$folder"
    then
        rm -rf "$folder/lnInclude"
    fi

    # A source taken out of Make/files would stay in the library
    target="$(sed -n 's/^ *\(LIB\|EXE\) *= *//p' "$folder/Make/files")"
    target="$(envsubstitute "$target")"
    if [ "$folder/Make/files" -nt "$objects/sourceFiles" ]
    then
        rm -f "$target" "$target.so"
    fi
}

# envsubstitute <text>: $(NAME) replaced by the environment's value
envsubstitute()
{
    local text="$1" name
    while [[ "$text" =~ \$\(([A-Za-z_]+)\) ]]
    do
        name="${BASH_REMATCH[1]}"
        text="${text/"\$($name)"/"${!name:-}"}"
    done
    echo "$text"
}

# missingHeaders <dependency file>: files it names that do not exist. OpenFOAM's
# own are left out (they start with a variable): etc/setup takes care of those.
missingHeaders()
{
    local file
    sed -n '/^\$/d; /^\/usr\//d; s/ *\\$//p' "$1" | while read -r file
    do
        [ -e "$file" ] || echo "$file"
    done
}

# newHeaders <folder>: has it a header that lnInclude has not, or a dead link?
newHeaders()
{
    local file
    [ -d "$1/lnInclude" ] || return 1
    [ -z "$(find -L "$1/lnInclude" -type l)" ] || return 0
    while read -r file
    do
        [ -e "$1/lnInclude/${file##*/}" ] || return 0
    done < <(find "$1" \( -name lnInclude -o -name Make \) -prune -o \
        -type f \( -name '*.H' -o -name '*.hpp' -o -name '*.h' \) -print)
    return 1
}
