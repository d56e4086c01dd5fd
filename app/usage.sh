# shellcheck shell=sh
# Functions of the scripts for their users; to be sourced. A script begins with a comment that is its help.

# Prints the comment at the head of the script.
usage() { sed -n '/^# shellcheck/d;2,/^[^#]/s/^# \{0,1\}//p' "$0"; }

# Prints the help and ends the script if the first argument asks for it.
offer_help() {
    case ${1-} in
    -h | --help)
        usage
        exit 0
        ;;
    esac
}

# wrong_usage MESSAGE: ends the script with a message.
wrong_usage() {
    echo "$(basename "$0"): $1 (see --help)" >&2
    exit 2
}
