// Points, added up so that the parts and the whole agree.
// SPDX-License-Identifier: MIT
#include "grader/judge/marks.hpp"

#include "grader/report/text.hpp"

#include <cmath>

namespace grader {

namespace {

constexpr double smallest = 0.01;  // points are told in hundredths

double rounded(double points) { return std::round(points * 100) / 100; }

}  // namespace

void countOldOnlyWithNew(std::vector<Check>& checks, Language language) {
    double got = 0, all = 0;
    for (const Check& check : checks)
        if (check.isNew) {
            got += check.score;
            all += check.maxScore;
        }
    if (all <= 0 || got >= all)
        return;
    const double share = got / all;
    for (Check& check : checks)
        if (!check.isNew && check.score > 0) {
            check.score *= share;
            check.message += say(language, " (counts only together with the new steps)",
                                 " (conta solo insieme ai passi nuovi)");
        }
}

void addUp(Report& report, double points) {
    double all = 0;
    bool full = true;
    for (const Check& check : report.checks) {
        all += check.maxScore;
        full = full && check.score >= check.maxScore;
    }
    const double scale = all > 0 ? points / all : 0;
    double sum = 0;
    for (Check& check : report.checks) {
        sum += check.score * scale;
        check.score = rounded(check.score * scale);
        check.maxScore = rounded(check.maxScore * scale);
    }
    // Parts are rounded each for itself, the whole once; and only who lost nothing has all points.
    report.maxScore = points;
    report.score = full && all > 0 ? points : std::max(0.0, std::min(rounded(sum), points - smallest));
}

}  // namespace grader
