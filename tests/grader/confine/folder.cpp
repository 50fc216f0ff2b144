// Where there are no namespaces: a private folder that stands for the root, of links and files, removed afterwards.
// SPDX-License-Identifier: MIT
#include "grader/confine/start.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <stdexcept>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

void runQuietly(std::vector<std::string> words) {
    std::vector<char*> list;
    for (std::string& word : words) {
        list.push_back(word.data());
    }
    list.push_back(nullptr);
    const Descriptor null = nothing();
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, null.number(), 1);
    ::posix_spawn_file_actions_adddup2(&actions, null.number(), 2);
    pid_t process = 0;
    if (::posix_spawnp(&process, list[0], &actions, nullptr, list.data(), ::environ) == 0) {
        ::waitpid(process, nullptr, 0);
    }
    ::posix_spawn_file_actions_destroy(&actions);
}

class PrivateFolder {
  public:
    explicit PrivateFolder(std::optional<uid_t> user) : user_(user) {
        std::string pattern = (fs::temp_directory_path() / "lambert-grade-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string() + ": " +
                                     std::strerror(errno));
        }
        root_ = pattern;
        if (user_.has_value()) {  // it may look, and only it
            check(::chown(root_.c_str(), 0, *user_) == 0 && ::chmod(root_.c_str(), 0750) == 0, root_);
        }
    }
    ~PrivateFolder() {
        // rm knows its way through what is nested deeper than a path is long.
        runQuietly({"rm", "-rf", "--", root_});
        std::error_code ignored;
        if (fs::exists(root_, ignored)) {
            runQuietly({"chmod", "-R", "u+rwx", "--", root_});
            runQuietly({"rm", "-rf", "--", root_});
        }
    }
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    const std::string& root() const { return root_; }

    void makeLink(const fs::path& from, const std::string& to) {
        fs::create_directories(fs::path(root_ + to).parent_path());
        fs::create_symlink(fs::absolute(from), root_ + to);
    }
    void makeFile(const std::string& to, const std::string& text) {
        const fs::path path = root_ + to;
        fs::create_directories(path.parent_path());
        std::ofstream file(path, std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        check(file.good() && ::chmod(path.c_str(), 0555) == 0, path);
    }
    // The box and all in it belong to the user.
    void giveBox() {
        fs::create_directories(root_ + "/box/out");
        if (!user_.has_value()) {
            return;
        }
        give(root_ + "/box");
        for (const auto& entry : fs::recursive_directory_iterator(root_ + "/box")) {
            give(entry.path());
        }
    }

  private:
    void give(const fs::path& path) { check(::lchown(path.c_str(), *user_, *user_) == 0, path); }
    static void check(bool done, const fs::path& path) {
        if (!done) {
            throw std::runtime_error("cannot prepare " + path.string() + ": " + std::strerror(errno));
        }
    }

    std::string root_;
    std::optional<uid_t> user_;
};

// RLIMIT_NPROC counts all of a user's threads, those of other programs too.
std::uint64_t threadsOfMine() {
    std::uint64_t count = 0;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator("/proc", error)) {
        struct stat status {};
        if (entry.path().filename().string().find_first_not_of("0123456789") == std::string::npos &&
            ::stat(entry.path().c_str(), &status) == 0 && status.st_uid == ::getuid()) {
            const auto tasks = fs::directory_iterator(entry.path() / "task", error);
            count += error ? 1 : static_cast<std::uint64_t>(std::distance(fs::begin(tasks), fs::end(tasks)));
        }
    }
    return count;
}

}  // namespace

Gathered runInFolder(const Job& asked, Walls walls, int slot) {
    Job job = asked;
    Start start;
    const Lease lease(slot);
    const std::optional<uid_t> user = lease.user();
    if (!user.has_value()) {
        job.limits.processes += static_cast<int>(threadsOfMine());
    }
    PrivateFolder folder(user);
    std::vector<std::string> readable = systemFolders();
    readable.push_back(folder.root());
    for (const Mount& mount : job.mounts) {
        folder.makeLink(mount.from, mount.to);
        readable.push_back(fs::absolute(mount.from).string());
    }
    for (const auto& [to, text] : job.texts) {
        folder.makeFile(to, text);
    }
    folder.giveBox();
    // It stays root where we are: so nothing inside can reach it, and it can become the user to end all that is left.
    start.files.push_back(inMemory(gradeInside()));
    start.command = {"/proc/self/fd/" + std::to_string(start.files.back().number()), "{job}", "{result}"};
    return gather(std::move(start), taskOf(job, walls, folder.root(), user, readable), job);
}

}  // namespace grader
