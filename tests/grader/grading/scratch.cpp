// Names that say whose they are, so that what is left over can be told from what is still written.
// SPDX-License-Identifier: MIT
#include "grader/grading/scratch.hpp"

#include "grader/submission/hash.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t machineDigits = 12;
constexpr auto longOver = std::chrono::hours(1);  // no submission takes that long: class/pool.hpp

// Where process numbers mean the same: a container counts its own, and a machine anew each time it starts.
const std::string& machine() {
    static const std::string digits = [] {
        std::array<char, 256> host{};
        gethostname(host.data(), host.size() - 1);
        std::ifstream boot("/proc/sys/kernel/random/boot_id");
        std::string all = host.data() + std::string(std::istreambuf_iterator<char>(boot), {});
        std::error_code none;
        all += fs::read_symlink("/proc/self/ns/pid", none).string();
        return sha256(all).substr(0, machineDigits);
    }();
    return digits;
}

// The process of a scratch name; 0: the name is none of ours. `ofHere`: it is, or was, one of this machine.
pid_t processOf(std::string_view name, bool& ofHere) {
    const std::size_t dot = machineDigits + 1;
    if (name.size() < dot + 2 || name[0] != '.' || name[dot] != '.' ||
        name.substr(1, machineDigits).find_first_not_of("0123456789abcdef") != std::string_view::npos)
        return 0;
    ofHere = name.substr(1, machineDigits) == machine();
    pid_t process = 0;
    const auto [end, error] = std::from_chars(name.data() + dot + 1, name.data() + name.size(), process);
    const std::string_view rest(end, static_cast<std::size_t>(name.data() + name.size() - end));
    const bool ours = rest == ".new" || rest == ".old" || rest == ".report";
    return error == std::errc() && ours && process > 0 ? process : 0;
}

bool isLeftOver(const fs::path& folder) {
    bool ofHere = false;
    const pid_t process = processOf(folder.filename().native(), ofHere);
    if (process == 0)
        return false;
    if (ofHere && (process == getpid() || (kill(process, 0) != 0 && errno == ESRCH)))
        return true;
    std::error_code error;
    const auto written = fs::last_write_time(folder, error);
    return !error && fs::file_time_type::clock::now() - written > longOver;
}

}  // namespace

std::string scratchMark() { return "." + machine() + "." + std::to_string(getpid()); }

void replaceFolder(const fs::path& fresh, const fs::path& place) {
    const fs::path old = place.parent_path() / (scratchMark() + ".old");
    std::error_code error;
    // Where two grade the same submission, one may put its result there between our two steps.
    for (int attempt = 0; attempt < 20; ++attempt) {
        fs::remove_all(old);
        fs::rename(place, old, error);
        fs::rename(fresh, place, error);
        if (!error) {
            fs::remove_all(old, error);
            return;
        }
        std::error_code ignored;
        fs::rename(old, place, ignored);
    }
    throw fs::filesystem_error("cannot put a result in its place", fresh, place, error);
}

void sweep(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
        if (isLeftOver(i->path())) {
            std::error_code ignored;
            fs::remove_all(i->path(), ignored);
        }
}

}  // namespace grader
