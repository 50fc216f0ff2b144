// Times frames round by round.
// SPDX-License-Identifier: MIT
#include "bench/error/cost.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <random>

namespace bench::error {

namespace {

constexpr int preparedFrames =
    20;  // compiled, uploaded, and seen to stand still for so long that lights are compiled in
constexpr int fewestFrames = 3, mostRounds = 101;

double processorMilliseconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double timeOf(Drawer& drawer) {
    const double start = processorMilliseconds();
    drawer.draw(false);
    return processorMilliseconds() - start;
}

double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

// The times of one method, round by round.
struct Samples {
    std::vector<double> frame, lighting, overFloor;

    void add(double time, double floor) {
        frame.push_back(time);
        lighting.push_back(time - floor);
        overFloor.push_back(time / floor);
    }
    Cost cost() const {
        return {quantile(frame, 0.5), quantile(lighting, 0.5),
                (quantile(lighting, 0.75) - quantile(lighting, 0.25)) / 2, quantile(overFloor, 0.5),
                static_cast<int>(frame.size())};
    }
};

// A method that takes longer than usual is drawn in every 2nd, 3rd, ... round only: those near the front need the time.
int everyRound(double milliseconds, double usual) {
    return std::clamp(static_cast<int>(milliseconds / (1.2 * usual)), 1, 16);
}

// How long each takes, after some frames that are not counted.
std::vector<double> prepare(Drawer& floor, const std::vector<Drawer*>& frames) {
    for (int i = 0; i < preparedFrames; ++i)
        floor.draw(false);
    std::vector<double> times;
    for (Drawer* const frame : frames) {
        double time = timeOf(*frame), all = time;
        for (int i = 1; i < preparedFrames && all < 6000; ++i)
            all += time = timeOf(*frame);
        times.push_back(time);
    }
    return times;
}

}  // namespace

std::vector<Cost> measure(Drawer& floor, const std::vector<Drawer*>& frames, double milliseconds) {
    const std::vector<double> expected = prepare(floor, frames);
    const double usual = quantile(expected, 0.5);
    std::vector<Samples> samples(frames.size());
    const double start = processorMilliseconds();
    const auto done = [&](int round) {
        return round >= mostRounds ||
               (round >= fewestFrames && processorMilliseconds() - start > milliseconds);
    };
    std::vector<std::size_t> turns(frames.size() + 1);  // the last is the floor's
    std::iota(turns.begin(), turns.end(), std::size_t{0});
    std::mt19937 random(2026);
    for (int round = 0; !done(round); ++round) {
        std::shuffle(turns.begin(), turns.end(), random);
        std::vector<double> times(frames.size());
        double flat = 0;
        for (const std::size_t i : turns)
            if (i == frames.size())
                flat = timeOf(floor);
            else if (round < fewestFrames || round % everyRound(expected[i], usual) == 0)
                times[i] = timeOf(*frames[i]);
        for (std::size_t i = 0; i < frames.size(); ++i)
            if (times[i] > 0)
                samples[i].add(times[i], flat);
    }
    std::vector<Cost> costs;
    for (const Samples& one : samples)
        costs.push_back(one.cost());
    return costs;
}

}  // namespace bench::error
