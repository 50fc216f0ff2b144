// The strongest walls: namespaces of its own, made by bubblewrap. Its list of arguments is the policy.
// SPDX-License-Identifier: MIT
#include "grader/confine/start.hpp"

#include <filesystem>

namespace grader {

namespace {

namespace fs = std::filesystem;

void add(std::vector<std::string>& words, std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
}

// A file of these bytes, made by bubblewrap itself: it lies in memory and needs no path outside that the user could read.
void addFile(Start& start, const std::string& bytes, const std::string& to) {
    start.files.push_back(inMemory(bytes));
    add(start.command, {"--perms", "0555", "--file", std::to_string(start.files.back().number()), to});
}

void addSystem(std::vector<std::string>& words) {
    for (const std::string& folder : systemFolders()) {
        if (fs::is_symlink(folder)) {  // /bin, /lib
            add(words, {"--symlink", fs::read_symlink(folder).string(), folder});
        } else {
            add(words, {"--ro-bind-try", folder, folder});
        }
    }
    add(words, {"--proc", "/proc", "--dev", "/dev"});
}

}  // namespace

Gathered runInBubblewrap(const Job& job, int slot) {
    Start start;
    const Lease lease(slot);
    start.user = lease.user();
    add(start.command, {"/usr/bin/bwrap", "--unshare-all", "--unshare-user", "--disable-userns",
                        "--die-with-parent", "--as-pid-1", "--new-session", "--clearenv"});
    addSystem(start.command);
    add(start.command,
        {"--size", std::to_string(job.limits.folderBytes), "--tmpfs", "/box", "--dir", "/box/out"});
    for (const Mount& mount : job.mounts) {
        add(start.command, {"--ro-bind", mount.from.string(), mount.to});
    }
    for (const auto& [to, text] : job.texts) {
        addFile(start, text, to);
    }
    addFile(start, gradeInside(), "/grade_inside");
    // These two lie in memory, too, and would take as much as anybody writes.
    add(start.command, {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/box", "--", "/grade_inside",
                        "{job}", "{result}"});
    return gather(std::move(start), taskOf(job, Walls::bubblewrap, "", {}, {}), job);
}

}  // namespace grader
