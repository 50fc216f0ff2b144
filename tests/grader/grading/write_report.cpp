// A graded submission on disk.
// SPDX-License-Identifier: MIT
#include "grader/grading/grader.hpp"
#include "grader/grading/scratch.hpp"
#include "grader/report/formats/formats.hpp"
#include "image/write.hpp"

namespace grader {

namespace fs = std::filesystem;

void writeReport(const Graded& graded, const fs::path& folder, const std::string& formats,
                 const std::map<std::string, std::string>& more) {
    const std::vector<Format> chosen = parseFormats(formats);
    const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
    const fs::path fresh = parent / (scratchMark() + ".report");
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    try {
        for (const Picture& picture : graded.pictures) {
            image::Frame frame{picture.image.width, picture.image.height, {}};
            if (picture.codes.empty())
                frame.pixels = picture.pixels;
            else
                frame.pixels = picture.codes;
            image::write((fresh / picture.image.file).string(), frame, {});
        }
        image::writeText((fresh / "report.json").string(), toJson(graded.report));
        for (const Format one : chosen)
            image::writeText((fresh / fileNameOf(one)).string(), format(graded.report, fresh, one));
        for (const auto& [name, text] : more)
            image::writeText((fresh / name).string(), text);
        replaceFolder(fresh, folder);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(fresh, ignored);
        throw;
    }
}

}  // namespace grader
