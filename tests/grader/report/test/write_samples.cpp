// Writes every sample report in every format, for a browser to show: FOLDER/<number>/report.html, ..., FOLDER/overview.html.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/formats.hpp"
#include "grader/report/test/samples.hpp"
#include "image/write.hpp"

#include <iostream>

using namespace grader;

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: write_report_samples FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::vector<ClassMember> members;
    for (const Report& report : samples::aClass()) {
        const std::string name = std::to_string(members.size());
        const std::filesystem::path own = folder / name;
        members.push_back({report, name + "/report.html"});
        std::filesystem::create_directories(own);
        samples::writeImages(report, own);
        for (const Format each :
             parseFormats("gradescope,prairielearn,autolab,coderunner,vpl,junit,csv,html"))
            image::writeText((own / fileNameOf(each)).string(), format(report, own, each));
    }
    image::writeText((folder / "overview.html").string(), overview(members, Language::en));
    image::writeText((folder / "marks.csv").string(), marksCsv(samples::aClass()));
}
