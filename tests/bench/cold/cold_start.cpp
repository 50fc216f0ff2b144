// Times cold processes by phases, in turns with the least that a process can do, and many frames in one process.
// SPDX-License-Identifier: MIT
//
//   cold_start BIN_DIRECTORY OUT_DIRECTORY [--quick]
//
// Each round runs everything once, and what is reported is the median over the rounds; a ratio is the median of the rounds'
// ratios, so that a machine that grows slower meanwhile slows both sides. The driver's cache of shaders is a folder of our own:
// filled before the first round ("warm"), or new for each run ("empty").
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
using Times = std::map<std::string, std::vector<double>>;  // milliseconds of each round, by what was timed

constexpr int batch = 100;
const char* const phaseNames[] = {"load",    "options", "scene",  "context", "plan",
                                  "compile", "draw",    "finish", "read",    "write"};

std::string readFile(const fs::path& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

// Whole or not at all.
void writeFile(const fs::path& path, const std::string& text) {
    const fs::path unfinished = path.string() + ".unfinished";
    if (!(std::ofstream(unfinished) << text << std::flush))
        throw std::runtime_error("cannot write '" + unfinished.string() + "'; expected a folder with room");
    fs::rename(unfinished, path);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

// The median of a[i] / b[i].
double ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        ratios.push_back(a[i] / b[i]);
    return median(ratios);
}

class Bench {
  public:
    Bench(fs::path bin, fs::path scratch) : bin_(std::move(bin)), scratch_(std::move(scratch)) {
        fs::create_directory(scratch_ / "warm");
        std::string lines;
        for (int i = 0; i < batch; ++i)
            lines += "--frame f.png --time " + std::to_string(i) + "e-2\n";
        writeFile(scratch_ / "frames.txt", lines);
        warm();
        for (int i = 0; i < 2; ++i) {  // fills the cache with every shader that the rounds need
            probe("");
            lesson("", {"--frame", "l.png", "--stats"});
            lesson("", {"--size", "64x64", "--frames-from", "frames.txt"});
            lesson("", {"--size", "64x64", "--frames", "5", "--stats"});
        }
        times.clear();
        version = lesson("", {"--version"});
        version = version.substr(version.find(' ') + 1, version.find('\n') - version.find(' ') - 1);
    }

    void round() {
        empty();
        coldStarts("empty");
        warm();
        probe("");  // so that nobody runs right after what filled a cache
        for (int i = 0; i < 3; ++i)
            coldStarts("warm");
        frames();
    }

    Times times;
    std::string driver, version;

  private:
    void warm() { setenv("MESA_SHADER_CACHE_DIR", (scratch_ / "warm").c_str(), 1); }
    void empty() {
        const fs::path folder = scratch_ / ("empty" + std::to_string(emptied_++));
        fs::create_directory(folder);
        setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
    }

    // Each of the two goes first as often as the other.
    void coldStarts(const std::string& cache) {
        const bool lessonFirst = (turn_ = !turn_);
        for (const bool phases : {false, true})
            for (const bool isLesson : {lessonFirst, !lessonFirst}) {
                if (cache == "empty")
                    empty();
                if (isLesson)
                    lesson(cache + " lesson", {"--frame", "l.png"}, phases);
                else
                    probe(cache + " probe", phases);
            }
    }

    // Many frames in one process, and what they should cost: a process, then frames and files.
    void frames() {
        lesson("frames all", {"--size", "64x64", "--frames-from", "frames.txt"});
        lesson("frames process", {"--size", "64x64", "--frame", "l.png"});
        const Json steady =
            Json::parse(lesson("", {"--size", "64x64", "--frames", std::to_string(batch), "--stats"}));
        times["frames steady"].push_back(steady["frame_ms"]["median"].get<double>());
        std::istringstream all(lesson("", {"--size", "64x64", "--frames-from", "frames.txt", "--stats"}));
        std::vector<double> writes;
        for (std::string line; std::getline(all, line);)
            writes.push_back(Json::parse(line)["phases_ms"]["write"].get<double>());
        times["frames write"].push_back(median(writes));
    }

    // Runs the lesson; its time goes under `name`, or with `phases` its phases do, each of its own.
    std::string lesson(const std::string& name, Words options, bool phases = false) {
        options.insert(options.begin(), "lesson_04_ambient");
        if (phases)
            options.emplace_back("--stats");
        const std::string out = run(phases ? "" : name, options);
        if (phases) {
            const Json stats = Json::parse(out);
            driver = stats["renderer"].get<std::string>();
            for (const auto& [phase, milliseconds] : stats["phases_ms"].items())
                times[name + " " + phase].push_back(milliseconds.get<double>());
        }
        return out;
    }

    void probe(const std::string& name, bool phases = false) {
        Words words{"probe_cold", "p.png"};
        if (phases)
            words.emplace_back("--phases");
        std::istringstream out(run(phases ? "" : name, words));
        std::string phase;
        for (double milliseconds = 0; out >> phase >> milliseconds;)
            times[name + " " + phase].push_back(milliseconds);
    }

    // Runs a program in the scratch folder; what it says is returned. Times it under `name`, if that is not empty.
    std::string run(const std::string& name, const Words& words) {
        const std::string program = (bin_ / words[0]).string();
        const std::string out = (scratch_ / "out").string();
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (std::size_t i = 1; i < words.size(); ++i)
            argv.push_back(const_cast<char*>(words[i].c_str()));
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0600);
        const auto start = std::chrono::steady_clock::now();
        pid_t child = 0;
        const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
        int status = 0;
        if (error == 0)
            waitpid(child, &status, 0);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0 || status != 0)
            throw std::runtime_error(
                program + " " + (error != 0 ? std::strerror(error) : "failed") +
                "; expected the lab's programs in BIN_DIRECTORY; build it all and try again");
        if (!name.empty())
            times[name].push_back(took.count());
        return readFile(out);
    }

    fs::path bin_, scratch_;
    bool turn_ = false;
    int emptied_ = 0;
};

// A bar's phases, and what none of them is: the kernel's share of starting and ending a process.
std::map<std::string, double> bar(const Times& times, const std::string& name) {
    std::map<std::string, double> parts;
    double rest = median(times.at(name));
    for (const char* phase : phaseNames) {
        const auto found = times.find(name + " " + phase);
        parts[phase] = found == times.end() ? 0 : median(found->second);
        rest -= parts[phase];
    }
    parts["rest"] = std::max(rest, 0.0);
    return parts;
}

std::string phasesCsv(const Times& times) {
    std::ostringstream csv;
    csv << "program";
    for (const char* phase : phaseNames)
        csv << ',' << phase;
    csv << ",kernel and exit,total\n";
    for (const auto& [name, title] : {std::pair{"warm lesson", "lesson, warm cache"},
                                      {"warm probe", "probe, warm cache"},
                                      {"empty lesson", "lesson, empty cache"},
                                      {"empty probe", "probe, empty cache"}}) {
        std::map<std::string, double> parts = bar(times, name);
        csv << '"' << title << '"';
        for (const char* phase : phaseNames)
            csv << ',' << parts[phase];
        csv << ',' << parts["rest"] << ',' << median(times.at(name)) << '\n';
    }
    return csv.str();
}

// What `batch` frames should cost, round by round.
std::vector<double> expected(const Times& times) {
    std::vector<double> sums;
    for (std::size_t i = 0; i < times.at("frames process").size(); ++i)
        sums.push_back(times.at("frames process")[i] +
                       batch * (times.at("frames steady")[i] + times.at("frames write")[i]));
    return sums;
}

std::string framesCsv(const Times& times) {
    std::ostringstream csv;
    csv << "what,one cold start and its frame,100 steady frames,100 PNG writes,all in one process\n";
    csv << "\"apart\"," << median(times.at("frames process")) << ','
        << batch * median(times.at("frames steady")) << ',' << batch * median(times.at("frames write"))
        << ",0\n";
    csv << "\"--frames-from\",0,0,0," << median(times.at("frames all")) << '\n';
    return csv.str();
}

std::string machine() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string today() {
    char text[16];
    const std::time_t now = std::time(nullptr);
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
    return text;
}

Json resultsJson(const Bench& bench) {
    Json results = Json::array();
    const auto add = [&results](const std::string& name, double value, const char* unit,
                                std::optional<double> target) {
        results.push_back({{"name", name},
                           {"value", value},
                           {"unit", unit},
                           {"target", target ? Json(*target) : Json(nullptr)},
                           {"ok", target ? Json(value <= *target) : Json(nullptr)}});
    };
    const Times& times = bench.times;
    const auto compare = [&](const std::string& cache, std::optional<double> target) {
        add("cold process to 512x512 PNG, " + cache + " cache: lesson", median(times.at(cache + " lesson")),
            "ms", {});
        add("cold process to 512x512 PNG, " + cache + " cache: probe", median(times.at(cache + " probe")),
            "ms", {});
        add("cold process to 512x512 PNG, " + cache + " cache: lesson / probe",
            ratio(times.at(cache + " lesson"), times.at(cache + " probe")), "ratio", target);
    };
    compare("warm", 1.15);
    compare("empty", {});
    add("100 frames of 64x64 by --frames-from", median(times.at("frames all")), "ms", {});
    add("one cold start, 100 steady frames and PNG writes", median(expected(times)), "ms", {});
    add("--frames-from / the same apart", ratio(times.at("frames all"), expected(times)), "ratio", 1.2);
    for (const char* name : {"warm lesson", "warm probe", "empty lesson", "empty probe"})
        for (const auto& [phase, milliseconds] : bar(times, name))
            add(std::string("phase, ") + name + ": " + phase, milliseconds, "ms", {});
    return {
        {"part", "cold"},         {"machine", machine()},     {"cores", std::thread::hardware_concurrency()},
        {"driver", bench.driver}, {"version", bench.version}, {"date", today()},
        {"results", results}};
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc == 4 && std::strcmp(argv[3], "--quick") == 0;
    if (argc < 3 || argc > 4 || (argc == 4 && !quick)) {
        std::cerr << "cold_start: expected BIN_DIRECTORY OUT_DIRECTORY [--quick]\n";
        return 2;
    }
    std::string scratch = (fs::temp_directory_path() / "lambert-cold-XXXXXX").string();
    const fs::path bin = fs::absolute(argv[1]), out = fs::absolute(argv[2]);
    int status = 0;
    try {
        if (mkdtemp(scratch.data()) == nullptr || chdir(scratch.c_str()) != 0)
            throw std::runtime_error("cannot make a temporary folder " + scratch);
        Bench bench(bin, scratch);
        const int rounds = quick ? 5 : 21;
        for (int i = 1; i <= rounds; ++i) {
            bench.round();
            if (isatty(STDERR_FILENO) != 0)
                std::cerr << "\rcold start: round " << i << '/' << rounds << (i == rounds ? "\n" : "")
                          << std::flush;
        }
        const Json json = resultsJson(bench);
        writeFile(out / "cold.csv", phasesCsv(bench.times));
        writeFile(out / "cold_frames.csv", framesCsv(bench.times));
        writeFile(out / "cold.json", json.dump(1) + "\n");
        for (const Json& row : json["results"])
            if (row["unit"] == "ratio")
                std::cout << row["name"].get<std::string>() << ": " << row["value"] << '\n';
    } catch (const std::exception& error) {
        std::cerr << "cold_start: " << error.what() << '\n';
        status = 3;
    }
    std::error_code ignored;
    fs::remove_all(scratch, ignored);
    return status;
}
