// Registers cases with Google Benchmark and keeps what it reports.
// SPDX-License-Identifier: MIT
#include "bench/timing.hpp"

#include "bench/report.hpp"
#include "image/write.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>

namespace bench {

namespace {

using Json = nlohmann::ordered_json;
using Samples = std::map<std::string, std::vector<double>>;

// Google Benchmark's own JSON, and on the way the time of each repetition.
class Collector final : public benchmark::JSONReporter {
  public:
    Collector() {
        SetOutputStream(&text);
        SetErrorStream(&errors);
    }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                samples[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
        JSONReporter::ReportRuns(runs);
    }
    Samples samples;
    std::ostringstream text, errors;
};

void initializeOnce() {
    static const bool done = [] {
        static char program[] = "bench";  // kept by Google Benchmark
        char shuffled[] = "--benchmark_enable_random_interleaving=true";
        char* arguments[] = {program, shuffled, nullptr};
        int count = 2;
        benchmark::Initialize(&count, arguments);
        return true;
    }();
    static_cast<void>(done);
}

}  // namespace

Samples Timing::samples(const std::vector<Case>& cases, int rounds, int frames) {
    initializeOnce();
    benchmark::ClearRegisteredBenchmarks();
    for (const Case& one : cases)
        benchmark::RegisterBenchmark(one.name.c_str(),
                                     [&one](benchmark::State& state) {
                                         one.frame();  // another case has been drawn in between
                                         for ([[maybe_unused]] auto turn : state)
                                             one.frame();
                                     })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(frames)
            ->Repetitions(rounds);
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
    runs_.push_back(collector.text.str());
    return collector.samples;
}

std::map<std::string, double> Timing::measure(const std::vector<Case>& cases, int rounds, int frames) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (const Case& one : cases)
        one.frame();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds * rounds * (frames + 1) > 60) {
        frames = 1;
        rounds = std::clamp(static_cast<int>(30 / seconds), 1, rounds);
    }
    std::map<std::string, double> medians;
    for (const auto& [name, times] : samples(cases, rounds, frames))
        medians[name] = median(times);
    return medians;
}

void Timing::write(const std::filesystem::path& file) const {
    Json all;
    for (const std::string& text : runs_) {
        const Json run = Json::parse(text);
        if (all.empty())
            all = run;
        else
            all["benchmarks"].insert(all["benchmarks"].end(), run["benchmarks"].begin(),
                                     run["benchmarks"].end());
    }
    std::filesystem::create_directories(file.parent_path());
    image::writeText(file.string(), all.dump(1) + "\n");
}

}  // namespace bench
