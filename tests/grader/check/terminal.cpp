// `check` without a window.
// SPDX-License-Identifier: MIT
#include "grader/check/feedback.hpp"
#include "grader/check/loops.hpp"
#include "grader/check/trio.hpp"

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace grader {

namespace {

volatile std::sig_atomic_t stopped = 0;

// The first signal lets the round end, which cleans up behind itself; the second one does not wait.
void stopOnSignals() {
    struct sigaction action {};
    action.sa_handler = [](int) { stopped = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int tell(const Graded& graded, const std::string& picture) {
    std::cout << textOf(graded);
    const std::vector<Trio> trios = picture.empty() ? std::vector<Trio>() : triosOf(graded);
    if (!trios.empty()) {
        writePicture(picture, trios.front(), graded.report);
        std::cout << say(graded.report.language,
                         "mine | expected | difference: ", "la mia | attesa | differenza: ")
                  << picture << "\n";
    }
    std::cout << std::flush;
    if (graded.report.status == ReportStatus::infrastructure)
        return CheckCannot;
    return allRight(graded.report) ? AllRight : NotYet;
}

std::string hashOf(const Grader& grader, const std::filesystem::path& file) {
    try {
        return grader.hashOf(file);
    } catch (const std::exception&) {  // an editor has taken it away for a moment
        return "";
    }
}

}  // namespace

int checkInTerminal(const CheckRequest& request) {
    stopOnSignals();
    const Grader grader(request.grading);
    if (request.once)
        return tell(grader.grade(request.file), request.picture);
    std::string judged;
    for (; stopped == 0; std::this_thread::sleep_for(std::chrono::milliseconds(200))) {
        std::string now = hashOf(grader, request.file);
        if (now.empty() || now == judged)
            continue;
        judged = std::move(now);
        tell(grader.grade(request.file), request.picture);
        std::cout << say(grader.language(), "waiting for the next save; Ctrl-C ends\n\n",
                         "aspetto il prossimo salvataggio; Ctrl-C per finire\n\n")
                  << std::flush;
    }
    return AllRight;
}

}  // namespace grader
