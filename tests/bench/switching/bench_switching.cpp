// What a change costs: in a window, where a symbol is toggled or a light dragged, and the first frame of shaders never seen before.
// SPDX-License-Identifier: MIT
//
//   bench_switching toggle|compile DIR [--quick | --smoke]      writes DIR/<part>.json, .csv
//
// Each is measured in a process of its own without Mesa's shader cache, and in one that finds everything in it (warm). Cold is, for
// compile, the one without; for toggle, whose thread hands over through the cache, one with a cache that is empty.
#include "bench/report.hpp"
#include "bench/switching/measure.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

namespace fs = std::filesystem;

// A folder for Mesa's cache, removed at the end.
class CacheFolder {
  public:
    CacheFolder() : path_((fs::temp_directory_path() / "bench-cache-XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw std::runtime_error("cannot make the folder " + path_ + " for Mesa's cache");
    }
    ~CacheFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    CacheFolder(const CacheFolder&) = delete;
    CacheFolder& operator=(const CacheFolder&) = delete;
    std::string environment() const {
        return "MESA_SHADER_CACHE_DISABLE=false MESA_SHADER_CACHE_DIR='" + path_ + "'";
    }

  private:
    std::string path_;
};

// One run of `child`, cold and then warm, the lines that it prints being `group<TAB>name<TAB>milliseconds`.
struct Row {
    std::string cache, group, name;
    double ms;
};
std::vector<Row> rowsOf(const std::string& cache, const std::string& text) {
    std::vector<Row> rows;
    std::istringstream lines(text);
    for (std::string group, name, ms;
         std::getline(lines, group, '\t') && std::getline(lines, name, '\t') && std::getline(lines, ms);)
        rows.push_back({cache, group, name, std::strtod(ms.c_str(), nullptr)});
    return rows;
}

// Three processes: without a shader cache, with one that is empty, and with all in it. Without one is "cold" unless `emptyIsCold`.
std::vector<Row> coldAndWarm(const std::string& part, const bench::Options& options, bool emptyIsCold) {
    const std::string child = "'" + fs::read_symlink("/proc/self/exe").string() + "' --child " + part +
                              (options.smoke   ? " --smoke"
                               : options.quick ? " --quick"
                                               : "");
    const CacheFolder cache;
    std::vector<Row> rows;
    const auto append = [&rows](const std::vector<Row>& more) {
        rows.insert(rows.end(), more.begin(), more.end());
    };
    bench::progress(1, 3, part + ": without Mesa's cache");
    append(rowsOf(emptyIsCold ? "no cache" : "cold",
                  bench::outputOf("MESA_SHADER_CACHE_DISABLE=true " + child)));
    bench::progress(2, 3, part + ": filling the cache");
    const std::string filling = bench::outputOf(cache.environment() + " " + child);
    if (emptyIsCold)
        append(rowsOf("cold", filling));
    bench::progress(3, 3, part + ": from the cache");
    append(rowsOf("warm", bench::outputOf(cache.environment() + " " + child)));
    return rows;
}

// What nobody is to notice; the drawing thread's own time, because the machine may be busy.
constexpr double mostOfAThread = 50;

// A group is "what, CPU, cache" or "what, until shown, cache".
void addGroup(bench::Report& out, const std::string& group, const std::vector<double>& ms) {
    const double worst = *std::max_element(ms.begin(), ms.end());
    const bool cpu = group.find("CPU") != std::string::npos;
    if (group.ends_with("cold"))
        out.add(group + ", median", bench::median(ms), "ms");
    if (cpu && group.ends_with("no cache"))
        out.add(group + ", worst", worst, "ms");
    else if (cpu)
        out.add(group + ", worst", worst, "ms", bench::Goal::atMost, mostOfAThread);
}

void report(const std::string& part, const bench::Options& options) {
    std::vector<Row> rows = coldAndWarm(part, options, part == "toggle");
    if (part == "toggle")  // with a cache of its own, which nothing else has filled
        for (Row& row : coldAndWarm("prepared", options, true))
            rows.push_back(std::move(row));
    std::string driver = "unknown", csv = "cache,group,name,ms\n";
    std::map<std::string, std::vector<double>> groups;
    for (const Row& row : rows)
        if (row.group == "driver") {
            driver = row.name;
        } else {
            groups[row.group + ", " + row.cache].push_back(row.ms);
            csv += row.cache + ",\"" + row.group + "\",\"" + row.name + "\"," + bench::digits(row.ms) + "\n";
        }
    bench::Report out(part, driver);
    if (part == "toggle")
        for (const auto& [group, ms] : groups)
            addGroup(out, group, ms);
    else
        for (const Row& row : rows)
            if (row.group != "driver")
                out.add(row.group + ", " + row.name + ", " + row.cache, row.ms, "ms");
    out.write(options.out, csv);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string part = count > 1 ? arguments[1] : "";
    if (part == "--child" && count > 2) {
        const std::string size = count > 3 ? arguments[3] : "";
        return bench::switchingChild(arguments[2], size);
    }
    if (part != "toggle" && part != "compile") {
        std::fprintf(stderr, "usage: bench_switching toggle|compile DIRECTORY [--quick | --smoke]\n");
        return 2;
    }
    const bench::Options options = bench::readOptions(count - 1, arguments + 1);
    return bench::guarded(
        "bench_switching",
        part == "toggle" ? [](const bench::Options& o) { report("toggle", o); }
                         : [](const bench::Options& o) { report("compile", o); },
        options);
}
