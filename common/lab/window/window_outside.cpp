// poll() on stdin, inotify and an eventfd.
// SPDX-License-Identifier: MIT
#include "lab/window/window_outside.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>
#include <utility>

namespace lab {

namespace {

constexpr std::size_t longestLine = 64 * 1024;
constexpr std::size_t mostWaiting = 256;  // events; a faster writer waits for the window
constexpr int backgroundRetry = 1000;  // ms

}  // namespace

void Outside::secureStdin() {
    if (fcntl(STDIN_FILENO, F_GETFD) == -1 && errno == EBADF && open("/dev/null", O_RDONLY) != STDIN_FILENO)
        return;  // then reading fails, which is the end of stdin as well
}

Outside::Outside(std::function<void()> wake)
    : wake_(std::move(wake)), notify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      signal_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)), thread_([this] { run(); }) {}

Outside::~Outside() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
    }
    tellWaiter();
    thread_.join();
    for (const int file : {notify_, signal_})
        if (file >= 0)
            close(file);
}

void Outside::tellWaiter() const {
    const std::uint64_t one = 1;
    while (write(signal_, &one, sizeof one) == -1 && errno == EINTR) {
    }
}

void Outside::watch(const std::vector<std::string>& folders) {
    const std::lock_guard lock(mutex_);
    std::map<int, std::string> now;
    for (const std::string& folder : folders) {
        const int id = inotify_add_watch(notify_, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO | IN_ONLYDIR);
        if (id >= 0)
            now.emplace(id, folder);
    }
    for (const auto& [id, folder] : folders_)
        if (!now.contains(id))
            inotify_rm_watch(notify_, id);
    folders_ = std::move(now);
}

std::vector<Event> Outside::take() {
    std::vector<Event> events;
    {
        const std::lock_guard lock(mutex_);
        events = std::exchange(queue_, {});
    }
    if (events.size() >= mostWaiting)
        tellWaiter();  // there is room again
    return events;
}

bool Outside::full() const {
    const std::lock_guard lock(mutex_);
    return queue_.size() >= mostWaiting;
}

void Outside::add(Event event) {
    {
        const std::lock_guard lock(mutex_);
        const auto same = [&event](const Event& other) {
            return other.kind == event.kind && other.text == event.text;
        };
        if (event.kind == Event::Kind::file && std::any_of(queue_.begin(), queue_.end(), same))
            return;
        queue_.push_back(std::move(event));
    }
    wake_();
}

void Outside::run() {
    sigset_t signals;
    sigfillset(
        &signals);  // those are the program's; and reading as a background job fails instead of stopping it
    pthread_sigmask(SIG_SETMASK, &signals, nullptr);
    for (;;) {
        const bool lines = reading_ && !background_ && !full();
        pollfd files[] = {{signal_, POLLIN, 0}, {notify_, POLLIN, 0}, {lines ? STDIN_FILENO : -1, POLLIN, 0}};
        const int ready = poll(files, 3, background_ ? backgroundRetry : -1);
        background_ = false;
        if (ready < 0 && errno != EINTR)
            return;
        if (ready <= 0)
            continue;
        if (files[0].revents != 0) {
            std::uint64_t count = 0;
            if (read(signal_, &count, sizeof count) < 0 && errno != EAGAIN)
                return;
            const std::lock_guard lock(mutex_);
            if (quit_)
                return;
        }
        if (files[1].revents != 0)
            readFiles();
        if (files[2].revents != 0)
            readLines();
    }
}

void Outside::readLines() {
    char buffer[16 * 1024];
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count < 0 && (errno == EINTR || errno == EAGAIN))
        return;
    const pid_t owner = count < 0 && errno == EIO ? tcgetpgrp(STDIN_FILENO) : -1;
    if (owner > 0 && owner != getpgrp()) {
        background_ = true;
        return;
    }
    const auto end = [this] {
        if (line_.ends_with('\r'))
            line_.pop_back();
        Event event{Event::Kind::line};
        event.text = std::exchange(line_, {});
        add(std::move(event));
    };
    std::string_view rest(buffer, count > 0 ? static_cast<std::size_t>(count) : 0);
    while (!rest.empty()) {
        const std::size_t length = std::min(rest.find('\n'), rest.size());
        line_.append(rest.substr(0, std::min(length, longestLine - std::min(longestLine, line_.size()))));
        if (length == rest.size())
            return;
        end();
        rest.remove_prefix(length + 1);
    }
    if (count > 0)
        return;
    reading_ = false;
    if (!line_.empty())
        end();
    add({Event::Kind::endOfLines});
}

void Outside::readFiles() {
    alignas(inotify_event) char buffer[16 * 1024];
    for (ssize_t count; (count = read(notify_, buffer, sizeof buffer)) > 0;)
        for (const char *at = buffer, *end = buffer + count; at < end;) {
            const auto& what = *reinterpret_cast<const inotify_event*>(at);
            at += sizeof what + what.len;
            if (what.len == 0 || (what.mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) == 0 ||
                (what.mask & IN_ISDIR) != 0)
                continue;
            Event event{Event::Kind::file};
            {
                const std::lock_guard lock(mutex_);
                const auto folder = folders_.find(what.wd);
                if (folder == folders_.end())
                    continue;
                event.text = folder->second + (folder->second.ends_with('/') ? "" : "/") + what.name;
            }
            add(std::move(event));
        }
}

}  // namespace lab
