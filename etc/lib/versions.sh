# Which OpenFOAM is in the environment, and is it supported (sourced, bash)
# Needs: SHOCKSHELL_DIR

# supportedVersion <minimum|tested|precision>: value in etc/supportedVersions
supportedVersion()
{
    sed -n "s/^$1  *\([^ #]*\).*/\1/p" "$SHOCKSHELL_DIR/etc/supportedVersions"
}

# openfoamApi <tree>: API number of an OpenFOAM.com tree, empty for others
openfoamApi()
{
    sed -n 's/^api *= *\([0-9]*\).*/\1/p' "$1/META-INFO/api-info" 2>/dev/null
}

# openfoamUsable: can the OpenFOAM of the environment build applications?
openfoamUsable()
{
    [ -n "${WM_PROJECT_DIR:-}" ] && [ -n "${WM_OPTIONS:-}" ] \
 && [ -x "$WM_PROJECT_DIR/wmake/wmake" ] \
 && [ -d "$WM_PROJECT_DIR/src/OpenFOAM/lnInclude" ] \
 && [ -e "${FOAM_LIBBIN:-}/libOpenFOAM.so" ]
}

# openfoamProblem: one line saying why the OpenFOAM of the environment cannot
# be used; empty when it can, or when there is none that could build anything
openfoamProblem()
{
    openfoamUsable || return 0

    local api least precision
    api="$(openfoamApi "$WM_PROJECT_DIR")"
    least="$(supportedVersion minimum)"
    precision="$(supportedVersion precision)"

    if [ -z "$api" ]
    then
        echo "$WM_PROJECT_DIR (${WM_PROJECT:-?} ${WM_PROJECT_VERSION:-?})" \
            "is not an OpenFOAM.com release of v$least or later"
    elif [ "$api" -lt "$least" ]
    then
        echo "$WM_PROJECT_DIR is OpenFOAM v$api, older than v$least"
    elif [ "${WM_PRECISION_OPTION:-}" != "$precision" ]
    then
        echo "$WM_PROJECT_DIR is built with WM_PRECISION_OPTION" \
            "${WM_PRECISION_OPTION:-unset}, not $precision"
    fi
}
