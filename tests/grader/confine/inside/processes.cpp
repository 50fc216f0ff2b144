// The command's processes: what they use, and their end.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dirent.h>
#include <filesystem>
#include <map>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace grader::inside {

namespace {

namespace fs = std::filesystem;

struct Process {
    pid_t id = 0;
    pid_t parent = 0;
};

std::vector<Process> allProcesses() {
    std::vector<Process> found;
    DIR* const proc = ::opendir("/proc");
    if (proc == nullptr) {
        return found;
    }
    while (const dirent* entry = ::readdir(proc)) {
        const auto id = static_cast<pid_t>(std::atoi(static_cast<const char*>(entry->d_name)));
        if (id <= 0) {
            continue;
        }
        std::FILE* const file = std::fopen(("/proc/" + std::to_string(id) + "/stat").c_str(), "re");
        char line[1024] = {};
        const std::size_t size = file != nullptr ? std::fread(line, 1, sizeof(line) - 1, file) : 0;
        if (file != nullptr) {
            std::fclose(file);
        }
        const std::size_t name = std::string(line, size).rfind(')');  // it may hold anything itself
        int parent = 0;
        if (name != std::string::npos && std::sscanf(line + name + 1, " %*c %d", &parent) == 1) {
            found.push_back({id, static_cast<pid_t>(parent)});
        }
    }
    ::closedir(proc);
    return found;
}

// All below us: as their reaper we inherit those whose parents are gone.
std::vector<pid_t> descendants() {
    std::multimap<pid_t, pid_t> children;
    for (const Process& process : allProcesses()) {
        children.emplace(process.parent, process.id);
    }
    std::vector<pid_t> found = {::getpid()};
    for (std::size_t i = 0; i < found.size() && i < 100'000; ++i) {
        const auto [begin, end] = children.equal_range(found[i]);
        for (auto child = begin; child != end; ++child) {
            found.push_back(child->second);
        }
    }
    found.erase(found.begin());
    return found;
}

std::uint64_t residentBytes(pid_t process) {
    std::FILE* const file = std::fopen(("/proc/" + std::to_string(process) + "/statm").c_str(), "re");
    unsigned long pages = 0;
    if (file != nullptr) {
        if (std::fscanf(file, "%*u %lu", &pages) != 1) {
            pages = 0;
        }
        std::fclose(file);
    }
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// A folder on a disk that others use, too: what lies in it.
void addFolder(const Task& task, Use& use) {
    std::error_code error;
    fs::recursive_directory_iterator entry(task.box, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator() && use.files <= task.files;
         entry.increment(error)) {
        struct stat status {};
        if (::lstat(entry->path().c_str(), &status) == 0) {
            use.folderBytes += static_cast<std::uint64_t>(status.st_blocks) * 512;
            ++use.files;
        }
    }
}

void killAs(std::int64_t user) {
    const pid_t helper = ::fork();
    if (helper == 0) {
        const auto id = static_cast<uid_t>(user);
        if (::setresuid(id, id, id) == 0) {
            ::kill(-1, SIGKILL);
        }
        ::_exit(0);
    }
    if (helper > 0) {
        ::waitpid(helper, nullptr, 0);
    }
}

}  // namespace

Use measure(const Task& task) {
    Use use;
    for (const pid_t process : descendants()) {
        use.memoryBytes += residentBytes(process);
    }
    struct statvfs box {};
    if (!task.namespaces) {
        addFolder(task, use);
    } else if (::statvfs(task.box.c_str(), &box) == 0) {
        use.folderBytes = (box.f_blocks - box.f_bfree) * box.f_frsize;
        use.files = box.f_files - box.f_ffree;
    }
    return use;
}

void endAll(const Task& task) {
    for (;;) {
        if (task.namespaces) {
            ::kill(-1, SIGKILL);  // never reaches beyond the namespace, nor ourselves
        } else if (task.user >= 0) {
            killAs(task.user);
        } else {
            for (const pid_t process : descendants()) {
                ::kill(process, SIGKILL);
            }
        }
        pid_t gone = 0;
        while ((gone = ::waitpid(-1, nullptr, WNOHANG)) > 0) {
        }
        if (gone < 0 && errno == ECHILD) {
            return;
        }
        const timespec pause{0, 1'000'000};
        ::nanosleep(&pause, nullptr);
    }
}

}  // namespace grader::inside
