// Results of a benchmark as JSON and CSV.
// SPDX-License-Identifier: MIT
#include "bench/report.hpp"

#include "image/write.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>
#include <utility>

namespace bench {

using Json = nlohmann::ordered_json;

namespace {

template <class T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

}  // namespace

Options readOptions(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--quick")
            options.quick = true;
        else if (word == "--smoke")
            options.smoke = options.quick = true;
        else if (options.out.empty() && !word.starts_with('-'))
            options.out = word;
        else
            count = 0;
    }
    if (options.out.empty() || count == 0) {
        std::fprintf(stderr, "usage: %s DIRECTORY [--quick | --smoke]\n", arguments[0]);
        std::exit(2);
    }
    return options;
}

Report::Report(std::string part, std::string driver) : part_(std::move(part)), driver_(std::move(driver)) {}

void Report::add(const std::string& name, double value, const std::string& unit) {
    results_.push_back({name, value, unit, std::nullopt, std::nullopt});
}

void Report::add(const std::string& name, double value, const std::string& unit, Goal goal, double target) {
    results_.push_back({name, value, unit, target, goal == Goal::atMost ? value <= target : value >= target});
}

std::string Report::json() const {
    Json json;
    json["part"] = part_;
    json["machine"] = processorName();
    json["cores"] = std::thread::hardware_concurrency();
    json["driver"] = driver_;
    json["version"] = LAMBERT_VERSION;
    json["date"] = today();
    json["results"] = Json::array();
    for (const Result& result : results_) {
        if (!std::isfinite(result.value))
            throw std::runtime_error("\"" + result.name + "\" of " + part_ + " is not a finite number");
        json["results"].push_back({{"name", result.name},
                                   {"value", std::strtod(digits(result.value).c_str(), nullptr)},
                                   {"unit", result.unit},
                                   {"target", orNull(result.target)},
                                   {"ok", orNull(result.ok)}});
    }
    return json.dump(1) + "\n";
}

void Report::write(const std::filesystem::path& directory) const {
    std::string csv = "name,value,unit,target,ok\n";
    for (const Result& result : results_)
        csv += "\"" + result.name + "\"," + digits(result.value) + "," + result.unit + "," +
               (result.target ? digits(*result.target) : "") + "," +
               (!result.ok   ? ""
                : *result.ok ? "yes"
                             : "no") +
               "\n";
    write(directory, csv);
}

void Report::write(const std::filesystem::path& directory, const std::string& csv) const {
    std::filesystem::create_directories(directory);
    image::writeText((directory / (part_ + ".json")).string(), json());
    image::writeText((directory / (part_ + ".csv")).string(), csv);
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%F", std::localtime(&now));
    return text;
}

std::string processorName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

int guarded(const char* program, void (*measure)(const Options&), const Options& options) {
    try {
        measure(options);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", program, error.what());
        return 1;
    }
}

void progress(std::size_t step, std::size_t steps, const std::string& what) {
    std::fprintf(stderr, "   [%zu/%zu] %s\n", step, steps, what.c_str());
}

}  // namespace bench
