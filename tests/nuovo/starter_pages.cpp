// The pages around a starter's lesson: how it is built, and what a student reads first.
// SPDX-License-Identifier: MIT
#include "starter_text.hpp"

namespace nuovo {
namespace {

constexpr const char* kCMake = R"(# @about@
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
project(@lesson@ LANGUAGES CXX)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()
find_package(LambertLab REQUIRED)
add_executable(@lesson@ @lesson@.cpp)
target_compile_options(@lesson@ PRIVATE -Wall -Wextra)
target_link_libraries(@lesson@ PRIVATE LambertLab::lab)
)";

constexpr const char* kItalian = R"(# @lesson@: da completare

`@lesson@.cpp` è la lezione precedente, e funziona già. Mancano i passi di queste slide; dopo, è `@lesson@`.

## Che cosa fare

In `@lesson@.cpp`:

@runs@@terms@## Compilare

`LAB` sta per il percorso completo della cartella in cui il laboratorio è installato (`cmake --install build --prefix LAB`):

    cmake -S . -B build -DCMAKE_PREFIX_PATH=LAB
    cmake --build build

Senza installarlo, `LAB` sta per quello della cartella dei suoi sorgenti, compilati nella sua `build`:

    cmake -S . -B build -DLambertLab_DIR=LAB/build
    cmake --build build

## Eseguire

    build/@lesson@@shaders@

Apre una finestra; con `--frame mio.png` scrive un'immagine, anche senza schermo. `--help` elenca il resto.
@overlay@
## È giusto?

    LAB/bin/check @lesson@ .

apre una finestra con la tua immagine, quella attesa e la differenza, dice che cosa non va, e guarda di nuovo a ogni
salvataggio; non serve compilare prima (senza installare: `LAB/build/bin/check`). Senza schermo scrive le tre immagini in
`check.png`. Un file solo: `LAB/bin/check @lesson@ @lesson@.cpp`.

Si può confrontare anche a mano. Il programma finito è `LAB/bin/@lesson@` (senza installare: `LAB/build/bin/@lesson@`). Alle stesse opzioni risponde con la
stessa immagine: `cmp` tace se i due file sono uguali.

    LAB/bin/@lesson@ --frame giusto.png
    build/@lesson@@shaders@ --frame mio.png
    cmp giusto.png mio.png

Deve valere anche da altrove e in altri momenti: riprova aggiungendo a entrambi `--jitter 1`, poi `--jitter 2 --time 1.5`,
poi `--camera -3,3.5,5,0,1,0`.
@check@)";

constexpr const char* kEnglish = R"(# @lesson@: to be completed

`@lesson@.cpp` is the previous lesson, and works already. The steps of these slides are missing; with them it is `@lesson@`.

## What to do

In `@lesson@.cpp`:

@runs@@terms@## Build

`LAB` stands for the full path of the folder where the lab is installed (`cmake --install build --prefix LAB`):

    cmake -S . -B build -DCMAKE_PREFIX_PATH=LAB
    cmake --build build

Without installing it, `LAB` stands for that of the folder of its sources, built in its `build`:

    cmake -S . -B build -DLambertLab_DIR=LAB/build
    cmake --build build

## Run

    build/@lesson@@shaders@

It opens a window; with `--frame mine.png` it writes a picture, without a display too. `--help` lists the rest.
@overlay@
## Is it right?

    LAB/bin/check @lesson@ .

opens a window with your picture, the expected one and the difference, says what is not right, and looks again whenever you
save; nothing needs to be built before (without installing: `LAB/build/bin/check`). Without a display it writes the three
pictures to `check.png`. A single file: `LAB/bin/check @lesson@ @lesson@.cpp`.

By hand it can be compared, too. The finished program is `LAB/bin/@lesson@` (without installing: `LAB/build/bin/@lesson@`). To the same options it answers
with the same picture: `cmp` is silent where the two files are equal.

    LAB/bin/@lesson@ --frame right.png
    build/@lesson@@shaders@ --frame mine.png
    cmp right.png mine.png

It must hold from elsewhere and at other times too: try again with `--jitter 1` added to both, then `--jitter 2 --time 1.5`,
then `--camera -3,3.5,5,0,1,0`.
@check@)";

/// What only lessons with shader exercises say.
const ByLanguage kTerms = {{"it", "In `terms/`, in GLSL:\n\n"}, {"en", "In `terms/`, in GLSL:\n\n"}};
const ByLanguage kOverlay = {
    {"it", "`--shaders .` mette i file di questa cartella al posto di quelli del laboratorio con lo stesso "
           "nome; senza, valgono "
           "i suoi.\nUn errore negli shader viene detto con file e riga, senza ricompilare.\n"},
    {"en", "`--shaders .` puts the files of this folder in place of the lab's files of the same name; "
           "without it the lab's "
           "hold.\nAn error in a shader is told with file and line, and nothing needs to be built again.\n"}};
const ByLanguage kCheck = {{"it", "Confronta anche i `.exr`, dove i numeri non sono tagliati tra 0 e 1 "
                                  "(l'ultima cifra può differire: conta chi "
                                  "arrotonda prima).\nSe con `--renderer reference`, che non usa gli shader, "
                                  "l'immagine è giusta e senza non lo è, "
                                  "l'errore è in `terms/`.\n"},
                           {"en",
                            "Compare `.exr` files too, where numbers are not cut to between 0 and 1 (a "
                            "last digit may differ: it matters who "
                            "rounds first).\nIf the picture is right with `--renderer reference`, which "
                            "uses no shaders, and wrong without, "
                            "the mistake is in `terms/`.\n"}};
const ByLanguage kAbout = {{"it", "Compila la lezione con il laboratorio; README.md dice come."},
                           {"en", "Builds the lesson with the lab; README.md says how."}};

std::string filled(std::string text, const std::map<std::string, std::string>& values) {
    for (const auto& [name, value] : values) {
        const std::string mark = "@" + name + "@";
        for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) {
            text.replace(at, mark.size(), value);
        }
    }
    return text;
}

/// A task as an item of a Markdown list.
std::string inList(std::string text) {
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
        text.replace(at, 1, "\n   ");
    }
    return withPlainBlanks(std::move(text));
}

/// "slide 37.5" as the tags count, for the list of tasks.
std::string listed(const Lesson& lesson, const LessonTasks& tasks, const std::string& lang) {
    const std::vector<NewRun> runs = runsOf(lesson);
    std::string text;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        text += std::to_string(i + 1) + ". slide " + toString(runs[i].cites) + ": " +
                inList(tasks.runs[i].at(lang)) + "\n";
    }
    return text + "\n";
}

std::string listedTerms(const LessonTasks& tasks, const std::string& lang) {
    std::string text = tasks.terms.empty() ? "" : kTerms.at(lang);
    for (const auto& [term, task] : tasks.terms) {
        text += "* `terms/" + term + ".glsl`: " + inList(task.at(lang)) + "\n";
    }
    return text + (tasks.terms.empty() ? "" : "\n");
}

}  // namespace

std::string starterCMake(const Lesson& lesson, const std::string& lang) {
    return filled(kCMake, {{"about", kAbout.at(lang)}, {"lesson", lesson.stem}});
}

std::string starterReadme(const Lesson& lesson, const LessonTasks& tasks, const std::string& lang) {
    const bool shaders = !tasks.terms.empty();
    return filled(lang == "it" ? kItalian : kEnglish, {{"lesson", lesson.stem},
                                                       {"runs", listed(lesson, tasks, lang)},
                                                       {"terms", listedTerms(tasks, lang)},
                                                       {"shaders", shaders ? " --shaders ." : ""},
                                                       {"overlay", shaders ? kOverlay.at(lang) : ""},
                                                       {"check", shaders ? kCheck.at(lang) : ""}});
}

}  // namespace nuovo
