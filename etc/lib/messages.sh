# Messages of the shell scripts (sourced, bash)

# note <text>: one line of progress, on stderr
note()
{
    echo "shockShellFoam: $*" 1>&2
}

# die <text>: stop with this as the last line, on stderr. Explanations are
# printed before it, because the last line is the one that gets read.
die()
{
    echo "shockShellFoam: error: $*" 1>&2
    exit 1
}
