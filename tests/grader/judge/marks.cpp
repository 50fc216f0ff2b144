// Points, added up so that the parts and the whole agree.
// SPDX-License-Identifier: MIT
#include "grader/judge/marks.hpp"

#include <cmath>

namespace grader {

namespace {

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
            check.message += language == Language::it ? " (conta solo insieme ai passi nuovi)"
                                                      : " (counts only together with the new steps)";
        }
}

void addUp(Report& report, double points) {
    double all = 0;
    for (const Check& check : report.checks)
        all += check.maxScore;
    report.score = report.maxScore = 0;
    for (Check& check : report.checks) {
        const double scale = all > 0 ? points / all : 0;
        check.score = rounded(check.score * scale);
        check.maxScore = rounded(check.maxScore * scale);
        report.score += check.score;
        report.maxScore += check.maxScore;
    }
    // Rounded parts may miss the whole by some hundredths: a faultless submission has all points.
    const bool full = report.score >= report.maxScore;
    report.maxScore = points;
    report.score = full ? points : rounded(std::min(report.score, points));
}

}  // namespace grader
