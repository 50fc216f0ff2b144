# shellcheck shell=bash disable=SC2034 # the package lists are used by the scripts that read this one
# Shared by lessons/run and tests/run: installs what is missing, then configures and builds.
# SPDX-License-Identifier: MIT

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

# Debian's names. README.md says what each library is for.
lesson_packages=(
    g++ cmake ninja-build pkg-config
    libglfw3-dev libegl-dev libgles-dev libglm-dev libimgui-dev nlohmann-json3-dev
    libcli11-dev libtinyobjloader-dev libpng-dev libopenexr-dev libopenimageio-dev
    # Found at run time only: Mesa's drivers, the libGL.so.1 that Debian's ImGui loads, the panel's font.
    libegl-mesa0 libgl1-mesa-dri libgl1 fonts-dejavu-core
)
test_packages=(
    libgtest-dev librapidcheck-dev libmpfr-dev libbenchmark-dev gnuplot-nox xvfb xdotool imagemagick
    # The grader: confinement, archives, hashes; its reports are read by xmllint.
    bubblewrap libseccomp-dev libarchive-dev libmd-dev libxml2-utils zip unzip
)
all_packages=(clang-14 clang-format-14 libclang-rt-14-dev chromium slurm-wlm munge iproute2)

say() { echo "== $*"; }

die() { # die STATUS LINE...: the first line says what is wrong, the others what to do
    printf 'error: %s\n' "$2" >&2
    [ $# -lt 3 ] || printf '    %s\n' "${@:3}" >&2
    exit "$1"
}

# install_missing PACKAGE...: does nothing, and starts one process only, when all are there.
install_missing() {
    local ID='' ID_LIKE='' VERSION_ID='' PRETTY_NAME='this system'
    # shellcheck source=/dev/null
    [ -r /etc/os-release ] && . /etc/os-release
    case " $ID $ID_LIKE " in
    *" debian "*) ;;
    *)
        [ -e "$root/build/build.ninja" ] || say "$PRETTY_NAME is no Debian: trying with what is here." \
            "These are needed, under Debian's names; if a step below misses one, install it by hand: $*"
        return
        ;;
    esac

    local installed missing=() package
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null)
    for package; do
        [[ $'\n'$installed$'\n' == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0

    local as_root=()
    if [ "$(id -u)" != 0 ]; then
        as_root=(sudo -n)
        local by_hand="su -c"
        command -v sudo >/dev/null && by_hand="sudo sh -c"
        sudo -n true 2>/dev/null ||
            die 3 "packages are missing, and installing them needs root. Run this line, then start again:" \
                "$by_hand 'apt-get update; apt-get install -y --no-install-recommends ${missing[*]}'"
    fi
    [ "$ID $VERSION_ID" = "debian 12" ] ||
        say "Debian 12 is what is promised and tested. This is $PRETTY_NAME: trying the same packages."
    say "Installing with apt-get: ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
    # A list that cannot be refreshed is no reason to stop: the install says what it cannot find.
    "${apt[@]}" update || say "Some package lists could not be refreshed; going on with those at hand."
    "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
        die 3 "apt-get could not install: ${missing[*]}" "Its message is above; repair that, then start again."
}

# build PRESET DIRECTORY OPTION TARGET...: OPTION is given to cmake unless the directory has it already.
build() {
    local preset=$1 name=$2 dir=$root/$2 option=$3
    shift 3
    local setting=${option#-D} cache='' stale=()
    # After a move of the tree, or where the last configuration was cut short, cmake starts afresh.
    [ -e "$dir/build.ninja" ] && [ -e "$dir/CMakeCache.txt" ] && cache=$(<"$dir/CMakeCache.txt")
    has() { [[ $'\n'$cache$'\n' == *$'\n'"$1"$'\n'* ]]; }
    has "CMAKE_HOME_DIRECTORY:INTERNAL=$root" || stale=(--fresh)
    if [ ${#stale[@]} -gt 0 ] || ! has "${setting/=/:BOOL=}"; then
        say "Configuring $name/"
        (cd "$root" && cmake --log-level=NOTICE --preset "$preset" -B "$dir" "$option" "${stale[@]}") ||
            die 1 "cmake could not configure $name/: its message is above."
    fi
    # A rehearsal that finds nothing to do keeps the second start silent.
    [[ $(ninja -C "$dir" -n "$@" 2>&1) != *"ninja: no work to do." ]] || return 0
    say "Building $name/"
    ninja -C "$dir" "$@" || die 1 "the build of $name/ failed: the compiler's message is above."
}

# locked COMMAND...: one run at a time installs and builds; a second one waits here.
locked() {
    local lock=$root/build/.lock
    { mkdir -p "$root/build" && : >>"$lock"; } 2>/dev/null ||
        die 5 "$(id -un) cannot write to $root/build." "Make it writable, or clone the project to another place."
    (
        flock -n 9 || { say "Waiting for another run to finish its build"; flock 9; }
        "$@" 9>&-
    ) 9>>"$lock"
}
