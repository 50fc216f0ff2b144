# shellcheck shell=bash disable=SC2034 # what is set here is read by the tests
# Shared by the tests that drive a window: a display of its own, checks, commands, keys, pictures.
# SPDX-License-Identifier: MIT
#
#   . lib.sh BIN_DIRECTORY WORK_DIRECTORY [SCREEN]      the screen is 1280x800 unless it is given

bin=$(cd "$1" && pwd)
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
rm -rf "$2" && mkdir -p "$2" && cd "$2" || exit 1
failures=0
check() { # check DESCRIPTION COMMAND...
    if "${@:2}"; then
        echo "ok      $1"
    else
        echo "FAILED  $1"
        failures=$((failures + 1))
    fi
}
finish() {
    [ $failures -eq 0 ] && exit 0
    echo "$failures failed; screenshots and what was said are in $PWD"
    exit 1
}

start_display() { # start_display SCREEN: sets xvfb, DISPLAY
    rm -f display
    Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset >xvfb.log 2>&1 3>display &
    xvfb=$!
    local _
    for _ in $(seq 100); do
        DISPLAY=:$(cat display)
        export DISPLAY
        [ "$DISPLAY" != : ] && xdotool getmouselocation >/dev/null 2>&1 && break
        sleep 0.1
    done
    unset WAYLAND_DISPLAY
}
lesson=
trap 'kill $lesson $xvfb 2>/dev/null; wait 2>/dev/null' EXIT
start_display "${3:-1280x800}"

# open_window PROGRAM OPTION...: starts it, with commands on descriptor 7, and waits for its window and first picture.
open_window() {
    name=$1
    shift
    rm -f commands && mkfifo commands
    LC_ALL=C "$bin/$name" "$@" <commands >out.txt 2>err.txt &
    lesson=$!
    exec 7>commands
    window=
    local _
    for _ in $(seq 300); do
        window=$(xdotool search --onlyvisible --name "^$name\$" 2>/dev/null | head -1) && [ -n "$window" ] && break
        kill -0 $lesson 2>/dev/null || break
        sleep 0.1
    done
    if [ -z "$window" ]; then
        echo "FAILED  no window of $name appeared:"
        cat err.txt out.txt xvfb.log
        exit 1
    fi
    xdotool windowmove --sync "$window" 0 0 windowfocus --sync "$window" mousemove 5 5
    say state
}
close_window() {
    xdotool windowfocus --sync "$window" key Escape
    wait $lesson
    check "$name: Esc leaves with status 0" test $? -eq 0
    check "$name: nothing was said on stderr" test ! -s err.txt
    exec 7>&-
}

# say COMMAND: says it and waits for its answer, which is the next line on stdout that starts as answers do. Sets answer.
say() {
    local before now _
    kill -0 $lesson 2>/dev/null || { answer="$name is gone"; return 1; }
    before=$(grep -cE '^(ok|error|probe) ' out.txt)
    echo "$1" >&7
    for _ in $(seq 200); do
        now=$(grep -cE '^(ok|error|probe) ' out.txt)
        if [ "$now" -gt "$before" ]; then
            answer=$(grep -E '^(ok|error|probe) ' out.txt | sed -n "$((before + 1))p")
            return 0
        fi
        sleep 0.05
    done
    answer="no answer to $1"
    return 1
}
# says COMMAND ANSWER: whether the answer is, or begins with, this.
says() {
    say "$1"
    [[ $answer == "$2"* ]] || { echo "        $1: $answer"; return 1; }
}
# becomes COMMAND ANSWER: the same as soon as it is so, for what a key or the mouse has asked for.
becomes() {
    local _
    for _ in $(seq 60); do
        say "$1"
        [[ $answer == "$2"* ]] && return 0
        sleep 0.05
    done
    echo "        $1: $answer, expected $2"
    return 1
}
value() { # value CONTROL: sets answer to its value
    say "$1"
    answer=${answer#"ok $1"}
    answer=${answer# }
}

press() { # press KEY...
    xdotool key "$@"
    sleep 0.2
}
# place WHAT: sets x and y to where a thing of the panel is: "widget term ambient", "group terms", "handle light 2", "divider".
place() {
    say places
    read -r x y < <(sed 's/^ok places //; s/;/\n/g' <<<"$answer" | sed -n "s/^$1 \([0-9-]*\) \([0-9-]*\)\$/\1 \2/p" | head -1)
    [ -n "${x:-}" ] || { echo "        $1 is nowhere on the panel"; return 1; }
}
click() { # click WHAT
    place "$1" && xdotool mousemove "$x" "$y" && sleep 0.1 && xdotool click 1 && sleep 0.2
}

# Where the panel does not reach, as a checksum in `seen`.
area=600x380+20+130
picture() { # picture NAME
    import -window "$window" "$1.png"
    seen=$(convert "$1.png" -crop $area +repage rgb:- | sha256sum)
}
# Looks again, for as long as a slow machine may need, until the picture is, or is not, that of the start.
same() { # same NAME
    local _
    for _ in $(seq 60); do
        picture "$1"
        [ "$seen" = "$start" ] && return
        sleep 0.1
    done
    return 1
}
differs() { # differs NAME
    local _
    for _ in $(seq 60); do
        picture "$1"
        [ "$seen" != "$start" ] && return
        sleep 0.1
    done
    return 1
}
remember() { # remember NAME: what is seen now is the start
    sleep 0.5
    picture "$1"
    start=$seen
}

# alike A B: whether two pictures are the same where the panel does not reach.
alike() {
    convert "$1" -crop $area +repage alike_1.ppm
    convert "$2" -crop $area +repage alike_2.ppm
    cmp -s alike_1.ppm alike_2.ppm
}

# Processor time that the program has used, hundredths of a second.
used() {
    local all
    all=$(<"/proc/$lesson/stat")
    # shellcheck disable=SC2086 # fields
    set -- ${all##*) }
    echo $(((${12} + ${13}) * 100 / $(getconf CLK_TCK)))
}
# Waits until the program has done what it had to do: a second without a tick of its clock. Sets before to what it has used.
settle() {
    local _
    for _ in $(seq 20); do
        before=$(used)
        sleep 1
        [ "$(used)" -le "$before" ] && break
    done
    before=$(used)
}
