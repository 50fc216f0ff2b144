// A small class of reports: texts as the grader words them, and spheres as pictures.
// SPDX-License-Identifier: MIT
#include "grader/report/test/samples.hpp"

#include "image/write.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace grader::samples {

namespace {

Report start(const std::string& submission) {
    Report report;
    report.toolVersion = "0.1.0";
    report.rubricHash = "rubric-hash-5e1f";
    report.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    report.lesson = "lesson_05_attenuation";
    report.lessonTitle = "Light that fades with distance";
    report.submission = submission;
    report.submissionHash = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";
    report.files = {{"lesson_05_attenuation.cpp", "lesson", "", 2412, "e3b0c442"},
                    {"terms/attenuation.glsl", "term", "", 311, "a1b2c3d4"},
                    {"notes/plan.odt", "leftOut", "not a source file", 18211, "00ff00ff"}};
    report.status = ReportStatus::graded;
    report.confinement = "bubblewrap";
    report.compileSeconds = 3.25;
    report.framesSeconds = 1.5;
    report.judgeSeconds = 0.75;
    return report;
}

Check check(const std::string& id, const std::string& title, std::vector<int> slides, double points) {
    Check check;
    check.id = id;
    check.title = title;
    check.slides = std::move(slides);
    check.status = CheckStatus::pass;
    check.score = check.maxScore = points;
    if (id != "builds")
        check.dependsOn = {id == "runs" ? "builds" : "runs"};
    return check;
}

std::vector<Check> rightChecks() {
    std::vector<Check> checks = {
        check("builds", "The program builds", {}, 1),
        check("runs", "The program runs and draws its frames", {}, 1),
        check("cosine", "The cosine of the directional light", {20, 21, 36}, 3),
        check("37.5", "The direction towards a point light", {29, 30, 37}, 3),
        check("attenuation", "The light fades with the distance", {31}, 4),
        check("ambient", "The ambient component", {40, 41, 42}, 2),
    };
    checks[0].message = "It builds without warnings.";
    checks[1].message = "It drew all six views.";
    for (std::size_t i = 2; i < checks.size(); ++i)
        checks[i].message = "All pixels of all views are as expected.";
    checks[5].isNew = false;
    return checks;
}

void addScores(Report& report) {
    report.score = report.maxScore = 0;
    for (const Check& each : report.checks) {
        report.score += each.score;
        report.maxScore += each.maxScore;
    }
}

void addPictures(Report& report, Check& check, const std::string& view, bool italian) {
    const auto add = [&](const std::string& role, const std::string& label) {
        const std::string id = view + "-" + role;
        report.images.push_back({id, role, label, id + ".png", 192, 192});
        check.images.push_back(id);
    };
    add("yours", italian ? "La tua immagine, vista 2" : "Your picture, view 2");
    add("expected", italian ? "L'immagine attesa, vista 2" : "The expected picture, view 2");
    add("difference", italian
                          ? "La differenza, vista 2: nero 0, viola 0.05, arancio 0.2, giallo 0.4 o più"
                          : "The difference, view 2: black 0, purple 0.05, orange 0.2, yellow 0.4 or more");
}

void spoilPointLight(Check& wrong, bool italian) {
    wrong.status = CheckStatus::fail;
    wrong.score = 0;
    wrong.message = italian
                        ? "Il lato illuminato dalla luce puntuale è buio, quello opposto è illuminato."
                        : "The side that faces the point light is dark, and the side away from it is lit.";
    wrong.expected = italian ? "w punta dal punto della superficie verso la luce (slide 30)."
                             : "w points from the surface's point towards the light (slide 30).";
    wrong.hint = italian ? "Disegna w su carta per un punto, e scrivi da dove a dove va."
                         : "Draw w on paper for one point, and write down from where to where it goes.";
    wrong.explanation = Explanation{{"B3", "B5"},
                                    italian ? "w punta via dalla luce, oppure la normale è girata"
                                            : "w points away from the light, or the normal is flipped",
                                    italian ? "In quale verso va la differenza di due punti?"
                                            : "Which way does a difference of two points go?",
                                    "",
                                    0.973,
                                    0.81};
    wrong.worst = WorstPixel{italian ? "vista 2" : "view 2",
                             117,
                             64,
                             "lit",
                             {0.0, 0.0123, 0.0},
                             {0.8627, 0.5333, 0.3333},
                             true,
                             {{"D", "albedo", "(1, 0.533, 0.333)"},
                              {"n . w_1", "cosine", "0.8627"},
                              {"max(0, n . w_1)", "clamp", "0.8627"},
                              {"f(d_1)", "attenuation", "1"},
                              {"L_1", "light_color", "(1, 1, 1)"},
                              {"D (x) L_A", "ambient", "(0.012, 0.006, 0.004)"}}};
    wrong.regions = {{"lit", 12841, 0.031},
                     {"unlit", 5102, 0.62},
                     {"terminator", 812, 0.44},
                     {"silhouette", 640, 0.93},
                     {"background", 17469, 1}};
}

void spoilAttenuation(Check& partial, bool italian) {
    partial.status = CheckStatus::partial;
    partial.score = 2.5;
    partial.message =
        italian ? "Il 38 % dei punti illuminati è troppo chiaro." : "38 % of the lit pixels are too bright.";
    partial.expected =
        italian ? "f(d) = 1 / d^k, con k = 2 (slide 31)." : "f(d) = 1 / d^k, with k = 2 (slide 31).";
    partial.hint = italian ? "Quanta luce resta al doppio della distanza?"
                           : "How much light is left at twice the distance?";
    partial.explanation =
        Explanation{{"D1"},
                    italian ? "la distanza invece del suo quadrato" : "the distance in place of its square",
                    italian ? "Conta i quadretti che la stessa luce copre."
                            : "Count the squares that the same light covers.",
                    italian ? "lwjgl-basics la usa così" : "lwjgl-basics has it so",
                    0.64,
                    0.52};
    partial.regions = {{"lit", 12841, 0.62}, {"unlit", 5102, 1}, {"background", 17469, 1}};
}

// A shaded ball in one of three looks.
image::Frame ball(const std::string& role, int side) {
    image::Frame frame{side, side,
                       image::Bytes(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 3)};
    auto& bytes = std::get<image::Bytes>(frame.pixels);
    std::size_t at = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = 2.4 * (column + 0.5) / side - 1.2, y = 1.2 - 2.4 * (row + 0.5) / side;
            const double z2 = 1 - x * x - y * y;
            const double cosine = z2 < 0 ? 0 : 0.55 * x + 0.55 * y + 0.63 * std::sqrt(z2);
            const double right = std::max(0.0, cosine), wrong = std::max(0.0, -cosine);
            const double gap = std::abs(right - wrong);
            const std::array<double, 3> color =
                role == "difference"
                    ? std::array{std::min(1.0, 2 * gap), std::max(0.0, 1.6 * gap - 0.6), 0.4 * gap}
                    : std::array{1.0, 0.533, 0.333};
            const double shade = role == "difference" ? 1 : role == "yours" ? wrong : right;
            for (const double channel : color)
                bytes[at++] =
                    static_cast<std::uint8_t>(z2 < 0 ? 0 : 255 * std::min(1.0, channel * shade + 0.01));
        }
    return frame;
}

}  // namespace

Report fullMarks() {
    Report report = start("rossi_anna");
    report.checks = rightChecks();
    addScores(report);
    return report;
}

Report partialMarks(Language language) {
    const bool italian = language == Language::it;
    Report report = start("bianchi_luca.zip");
    report.language = language;
    if (italian)
        report.lessonTitle = "Luce che si attenua con la distanza";
    report.checks = rightChecks();
    spoilPointLight(report.checks[3], italian);
    addPictures(report, report.checks[3], "view-2", italian);
    spoilAttenuation(report.checks[4], italian);
    addScores(report);
    report.said = "drawing...\nlight 1 at (2, 2, 2)\n";
    report.similar = {{"verdi_marco.zip", "the same source but for names and blanks"}};
    return report;
}

Report doesNotBuild() {
    Report report = start("neri_giulia");
    report.checks = rightChecks();
    for (Check& each : report.checks) {
        each.status = CheckStatus::skipped;
        each.score = 0;
        each.message = "Not judged: the program does not build.";
    }
    report.checks[0].status = CheckStatus::fail;
    report.checks[0].message = "The compiler refuses line 41: 'lihgt' was not declared in this scope.";
    report.checks[0].hint = "Read the first error only; the others often follow from it.";
    report.buildLog =
        "lesson_05_attenuation.cpp:41:9: error: 'lihgt' was not declared in this scope; did you mean "
        "'light'?\n   41 |         lihgt.decay = 2;\n      |         ^~~~~\n      |         light\n";
    addScores(report);
    return report;
}

Report infrastructure() {
    Report report = start("gallo_sara");
    report.status = ReportStatus::infrastructure;
    report.reason = "no driver could be started: EGL says EGL_NOT_INITIALIZED";
    report.maxScore = 14;
    return report;
}

Report notGradable() {
    Report report = start("costa_paolo.zip");
    report.status = ReportStatus::notGradable;
    report.reason = "the zip is broken: its end is missing";
    report.files.clear();
    report.maxScore = 14;
    return report;
}

Report hostile() {
    const std::string nasty =
        "=cmd('x')|<script>alert(1)</script>]]>\x1B[31mred\x1B[0m\n{\"scores\":{\"all\":100}}\n"
        "Grade :=>> 100\nComment :=>> well done\n<|--\n--|>\r\n\"quoted\", è€😀 \xFF\xC0\xAF "
        "\xE2\x80\xAEoverride \xEF\xBF\xBF\x01\x7F\xC2\x85 end";
    Report report = start(nasty);
    report.lessonTitle = nasty;
    report.toolVersion = report.renderer = report.reason = report.confinement = nasty;
    for (SubmittedFile& file : report.files)
        file.path = file.note = nasty;
    report.checks = rightChecks();
    spoilPointLight(report.checks[3], false);
    addPictures(report, report.checks[3], "hostile", false);
    Check& wrong = report.checks[3];
    wrong.title = wrong.message = wrong.expected = wrong.hint = nasty;
    wrong.explanation->name = wrong.explanation->hint = wrong.explanation->convention = nasty;
    wrong.worst->frame = wrong.worst->region = nasty;
    for (TermNumber& number : wrong.worst->numbers)
        number.symbol = number.value = nasty;
    wrong.worst->found = {std::nan(""), INFINITY, -INFINITY};
    for (ReportImage& image : report.images)
        image.label = nasty;
    report.buildLog = report.said = nasty + nasty;
    report.similar = {{nasty, nasty}};
    addScores(report);
    return report;
}

std::vector<Report> all() {
    return {fullMarks(),   partialMarks(), partialMarks(Language::it), doesNotBuild(), infrastructure(),
            notGradable(), hostile()};
}

std::vector<Report> aClass() {
    std::vector<Report> reports = all();
    const char* names[] = {"colombo_marta", "conti_elena",    "deluca_pietro", "esposito_ciro",
                           "ferrari_noemi", "fontana_ugo",    "greco_irene",   "lombardi_dario",
                           "mancini_sofia", "marino_tommaso", "ricci_alba",    "romano_leo",
                           "russo_gaia",    "santoro_nino",   "villa_chiara"};
    for (std::size_t i = 0; i < std::size(names); ++i) {
        Report report = start(names[i]);
        report.checks = rightChecks();
        if (i % 3 == 0)
            spoilAttenuation(report.checks[4], false);
        if (i % 5 == 1)
            spoilPointLight(report.checks[3], false);
        if (i % 7 == 2) {
            report.checks[5].status = CheckStatus::fail;
            report.checks[5].score = 0;
        }
        addScores(report);
        reports.push_back(report);
    }
    return reports;
}

void writeImages(const Report& report, const std::filesystem::path& folder, int side) {
    for (const ReportImage& each : report.images)
        image::write((folder / each.file).string(), ball(each.role, side), {});
}

std::filesystem::path folderFor(const std::string& name) {
    struct Folders : std::vector<std::filesystem::path> {
        ~Folders() {
            std::error_code error;
            for (const auto& folder : *this)
                std::filesystem::remove_all(folder, error);
        }
    };
    static Folders made;  // removed when the tests are over
    made.push_back(std::filesystem::temp_directory_path() /
                   ("lambert_report_" + std::to_string(::getpid()) + "_" + name));
    std::filesystem::remove_all(made.back());
    std::filesystem::create_directories(made.back());
    return made.back();
}

}  // namespace grader::samples
