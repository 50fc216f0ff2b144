#!/usr/bin/env bash
# Gradescope runs this once, as root, when the image is built: installs Debian's or Ubuntu's packages and builds the grader.
# SPDX-License-Identifier: MIT
# shellcheck disable=SC1091,SC2154 # what it reads comes with the archive

set -euo pipefail
root=${AUTOGRADER_ROOT:-/autograder}
lab=$root/lambert-lab

mkdir -p "$lab"
tar -xzf "$root/source/lambert-lab.tar.gz" -C "$lab"
lesson=$(<"$root/source/lesson")

. "$lab/lessons/setup.sh" # lesson_packages, test_packages
if [ -z "${LAMBERT_SKIP_PACKAGES:-}" ]; then
    export DEBIAN_FRONTEND=noninteractive
    apt-get update
    apt-get install -y --no-install-recommends "${lesson_packages[@]}" "${test_packages[@]}"
fi

cmake_version=$(cmake --version | sed -nE '1s/^cmake version ([0-9.]+).*/\1/p')
if [ "$(printf '%s\n' 3.25 "$cmake_version" | sort -V | head -n 1)" != 3.25 ]; then
    echo "error: the lab needs cmake 3.25 or newer, as in Debian 12; found $cmake_version" >&2
    echo "    Choose an image with Debian 12 or Ubuntu 24.04 in the assignment's autograder settings." >&2
    exit 3
fi

# Without the tests of the lab itself: what is needed to build, run and judge this lesson.
cmake -S "$lab" -B "$lab/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLAMBERT_TESTS=ON
cmake --build "$lab/build" --target grader

# An image that cannot draw should fail now, not on the first submission.
"$lab/build/bin/$lesson" --size 16x16 --frame "$lab/build/first.png"
