// Times frames round by round.
// SPDX-License-Identifier: MIT
#include "bench/error/cost.hpp"

#include <algorithm>
#include <ctime>
#include <map>

namespace bench::error {

namespace {

constexpr int preparedFrames = 3;  // compiled, uploaded, and seen to stand still
constexpr int mostRounds = 101;

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

// The times of one method, and of its floor in the same rounds.
struct Samples {
    std::vector<double> frame, lighting, overFloor;

    Cost cost() const {
        return {quantile(frame, 0.5), quantile(lighting, 0.5),
                (quantile(lighting, 0.75) - quantile(lighting, 0.25)) / 2, quantile(overFloor, 0.5),
                static_cast<int>(frame.size())};
    }
};

// How long each takes, after some frames that are not counted.
std::vector<double> prepare(const std::vector<Timed>& timed) {
    std::vector<double> times;
    for (const Timed& one : timed) {
        double time = timeOf(*one.frame);
        for (int i = 1; i < preparedFrames && time < 1000; ++i)
            time = timeOf(*one.frame);
        one.floor->draw(false);
        times.push_back(time);
    }
    return times;
}

}  // namespace

std::vector<Cost> measure(const std::vector<Timed>& timed, double milliseconds) {
    const std::vector<double> expected = prepare(timed);
    const double usual = quantile(expected, 0.5);
    std::vector<int> everyRound;  // drawn in every n-th round
    for (const double time : expected)
        everyRound.push_back(std::clamp(static_cast<int>(time / (4 * usual)), 1, 16));
    std::vector<Samples> samples(timed.size());
    const double start = processorMilliseconds();
    const auto done = [&](int round) {
        const bool enough =
            std::all_of(samples.begin(), samples.end(), [](const Samples& s) { return s.frame.size() >= 3; });
        return round >= mostRounds || (enough && processorMilliseconds() - start > milliseconds);
    };
    for (int round = 0; !done(round); ++round) {
        std::map<Drawer*, double> floors;
        for (std::size_t turn = 0; turn < timed.size(); ++turn) {
            const std::size_t i = (turn + static_cast<std::size_t>(round)) % timed.size();
            // The slow ones at first, so that everything has its three frames soon.
            if (samples[i].frame.size() >= 3 && round % everyRound[i] != 0)
                continue;
            if (!floors.contains(timed[i].floor))
                floors[timed[i].floor] = timeOf(*timed[i].floor);
            const double floor = floors[timed[i].floor], frame = timeOf(*timed[i].frame);
            samples[i].frame.push_back(frame);
            samples[i].lighting.push_back(frame - floor);
            samples[i].overFloor.push_back(frame / floor);
        }
    }
    std::vector<Cost> costs;
    for (const Samples& one : samples)
        costs.push_back(one.cost());
    return costs;
}

}  // namespace bench::error
