// What reaches a window from outside: lines of stdin, saved files; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace lab {

/// A thread that waits for stdin and for folders, without any CPU while nothing comes.
class Outside {
  public:
    /// `wake` is called from the thread whenever there is something to take.
    explicit Outside(std::function<void()> wake);
    ~Outside();
    Outside(const Outside&) = delete;
    Outside& operator=(const Outside&) = delete;

    /// Replaces what was watched. Folders that do not exist are left out; those in them are not watched. A
    /// file counts as saved when it is closed after writing, or moved to its name, as editors do.
    void watch(const std::vector<std::string>& folders);
    /// What came since the last call: Event::Kind::line, endOfLines (once) and file, in order; a file saved
    /// several times stands there once. Lines have no \r\n, and no more than 64 KiB: what follows of a longer
    /// one is dropped.
    std::vector<Event> take();

    /// Takes the place of a stdin that is closed, so that no other file becomes it. Before anything opens
    /// files.
    static void secureStdin();

  private:
    void run();
    void readLines();
    void readFiles();
    void add(Event event);
    void tellWaiter() const;
    bool full() const;

    std::function<void()> wake_;
    int notify_ = -1;  // inotify
    int signal_ = -1;  // eventfd: look at quit_ and queue_ again
    mutable std::mutex mutex_;
    std::vector<Event> queue_;
    std::map<int, std::string> folders_;  // by their watch
    bool quit_ = false;
    // Of the thread alone:
    std::string line_;  // begun and not ended
    bool reading_ = true;  // stdin has not ended
    bool background_ = false;  // it is the terminal of another program for now
    std::thread thread_;
};

}  // namespace lab
