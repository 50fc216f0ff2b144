// From results to the mark sheet and the overview of a class.
// SPDX-License-Identifier: MIT
#include "grader/class/class.hpp"
#include "grader/class/entries.hpp"
#include "grader/class/result.hpp"
#include "grader/class/similarity.hpp"
#include "grader/report/formats/formats.hpp"
#include "grader/report/text.hpp"
#include "image/write.hpp"

#include <algorithm>
#include <iostream>

namespace grader {

namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string>;

std::string list(const Names& names) {
    constexpr std::size_t most = 20;
    std::string text;
    std::size_t count = 0;
    for (const std::string& name : names)
        if (++count <= most)
            text += (text.empty() ? "" : ", ") + oneLine(name);
    return count > most ? text + ", and " + std::to_string(count - most) + " more" : text;
}

void tell(const std::string& what, const Names& names) {
    if (!names.empty())
        std::cerr << "grade: " << what << ": " << list(names) << std::endl;
}

// Stands for a result that is not there, so that nobody is missing from the mark sheet without a word.
Result noResult(const std::string& name, Language language) {
    Result result;
    result.folder = name;
    result.report.submission = name;
    result.report.language = language;
    result.report.reason = say(language, "there is no whole result; grade again with --resume",
                               "non c'è un risultato completo; si rifà con --resume");
    return result;
}

class Collection {
  public:
    /// `submissions` may be empty: then what is there is all there is.
    Collection(const fs::path& report, Language language, const fs::path& submissions)
        : language_(language), known_(!submissions.empty()) {
        if (known_)
            for (const fs::path& entry : entriesOf(submissions))
                names_.insert(entry.filename().string());
        Names missing = names_;
        for (const fs::path& folder : entriesOf(resultsFolder(report))) {
            const std::string name = folder.filename().string();
            if (known_ && missing.erase(name) == 0)
                gone_.insert(name);
            else
                add(folder, name);
        }
        for (const std::string& name : missing)
            addNothing(name);
        std::sort(results_.begin(), results_.end(),
                  [](const Result& a, const Result& b) { return a.folder < b.folder; });
    }

    void tellAll() const {
        tell("results of submissions that are not there any more, left out", gone_);
        tell("without a whole result (grade again with --resume)", missing_);
        if (keys_.size() > 1)
            std::cerr
                << "grade: these results were made by " << keys_.size()
                << " different graders or rubrics; to make all anew where they differ: grade again with "
                   "--resume"
                << std::endl;
    }
    std::vector<Result>& results() { return results_; }

  private:
    void add(const fs::path& folder, const std::string& name) {
        std::optional<Result> result = readResult(folder);
        if (!result)
            return addNothing(name);
        keys_.insert({result->key.tool, result->key.rubric});
        results_.push_back(std::move(*result));
    }
    void addNothing(const std::string& name) {
        missing_.insert(name);
        results_.push_back(noResult(name, language_));
    }

    Language language_;
    bool known_;
    Names names_, gone_, missing_;
    std::set<std::pair<std::string, std::string>> keys_;
    std::vector<Result> results_;
};

// What is linked to: the student's page, or, where none was asked for, the folder's only sure file.
std::string pageOf(const fs::path& report, const Result& result) {
    const std::string page = fileNameOf(Format::html);
    std::error_code none;
    const bool there = fs::exists(resultsFolder(report) / result.folder / page, none);
    return "results/" + result.folder + "/" + (there ? page : "report.json");
}

}  // namespace

int mergeClass(const fs::path& report, Language language, const fs::path& submissions) {
    Collection collection(report, language, submissions);
    std::vector<Result>& results = collection.results();
    if (results.empty())
        throw UsageError(resultsFolder(report).string() + ": holds no result; grade the class first");
    collection.tellAll();
    findSimilar(results, language);
    std::vector<Report> reports;
    std::vector<ClassMember> members;
    int failed = 0;
    for (const Result& result : results) {
        reports.push_back(result.report);
        members.push_back({result.report, pageOf(report, result)});
        failed += result.report.status == ReportStatus::infrastructure ? 1 : 0;
    }
    image::writeText((report / "marks.csv").string(), marksCsv(reports));
    image::writeText((report / "overview.html").string(), overview(members, language));
    std::cout << results.size() << " results, " << failed
              << " of them for the grader's own trouble without marks: " << (report / "marks.csv").string()
              << ", " << (report / "overview.html").string() << std::endl;
    return failed;
}

}  // namespace grader
