// Reads the command line with CLI11; every mistake is named with what was expected.
// SPDX-License-Identifier: MIT
#include "lab/options.hpp"

#include "lab/failure.hpp"
#include "lab/live/values.hpp"
#include "lab/number.hpp"
#include "lab/switches.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>
#include <vector>

namespace lab {

namespace {

constexpr int largestSize = 8192;

double finite(const std::string& option, const std::string& text) {
    const std::optional<double> value = quantity(text);
    if (!value || !(std::abs(*value) <= 1e36))
        throw CLI::ValidationError(option, "expected a finite number, found '" + text + "'");
    return *value;
}

std::string listTerms(Language language) {
    std::ostringstream out;
    for (const lighting::TermInfo& row : lighting::terms())
        out << static_cast<int>(row.term) + 1 << "  " << row.name << "  " << row.symbol << "  slide "
            << row.slides << "  " << say(row.meaning, language)
            << (language == Language::it ? "; spento: " : "; off: ") << say(row.off, language) << '\n';
    return out.str();
}

// What `read` reads; what it refuses is the option's mistake.
template <class Read>
auto checked(const char* option, const Read& read) {
    try {
        return read();
    } catch (const UsageError& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

// Set before the options are described: --help is written in it.
Language descriptions = Language::en;
std::string text(const char* it, const char* en) { return say({it, en}, descriptions); }

// What --lang says, looked for before everything else; what is wrong with it is said later.
Language languageOf(std::span<const std::string> arguments) {
    Language language = languageOfLocale();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view word = arguments[i];
        const std::string_view next = i + 1 < arguments.size() ? std::string_view(arguments[i + 1]) : "";
        if (word == "--lang=it" || (word == "--lang" && next == "it"))
            language = Language::it;
        else if (word == "--lang=en" || (word == "--lang" && next == "en"))
            language = Language::en;
    }
    return language;
}

// Describes an option whose text `read` turns into a value.
struct Adder {
    CLI::App& app;
    CLI::Option* operator()(const std::string& name, const char* it, const char* en,
                            const std::function<void(const std::string&)>& read) const {
        return app.add_option_function<std::string>(name, read, text(it, en));
    }
};

void addNumbers(CLI::App& app, Options& options) {
    const Adder add{app};
    add("--size", "LxA: 512x512 per un'immagine, 960x600 per una finestra",
        "WxH: 512x512 for a frame, 960x600 for a window", [&options](const std::string& value) {
            const auto [width, height] = checked("--size", [&] { return readSize(value); });
            options.width = width;
            options.height = height;
        });
    add("--time", "il tempo dell'animazione, in secondi (0)", "the animation's time in seconds (0)",
        [&options](const std::string& value) { options.time = finite("--time", value); });
    add("--decay", "l'esponente k di ogni luce posizionale", "the exponent k of every point light",
        [&options](const std::string& value) {
            options.decay = finite("--decay", value);
            if (*options.decay < 0)
                throw CLI::ValidationError("--decay", "expected 0 or more, found '" + value + "'");
        });
    add("--camera", "px,py,pz,tx,ty,tz[,fov]: dove sta, cosa guarda, apertura in gradi",
        "px,py,pz,tx,ty,tz[,fov]: where it stands, what it looks at, angle of view",
        [&options](const std::string& value) {
            options.camera = checked("--camera", [&] { return readCamera(value); });
        });
    add("--jitter", "SEME: piccole variazioni di camera, luci e oggetti",
        "SEED: small changes of camera, lights and meshes", [&options](const std::string& value) {
            options.jitter = number<std::uint64_t>(value);
            if (!options.jitter)
                throw CLI::ValidationError("--jitter",
                                           "expected a whole number from 0 on, found '" + value + "'");
        });
    add("--light-cut", "CODICI: tralascia luce finché a nessun pixel ne mancano più di tanti codici a 8 bit",
        "CODES: leaves out light as long as no pixel lacks more than so many 8-bit codes",
        [&options](const std::string& value) {
            options.lightCut = finite("--light-cut", value);
            if (options.lightCut < 0 || options.lightCut > 255)
                throw CLI::ValidationError("--light-cut", "expected 0 to 255, found '" + value + "'");
        });
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&options](const std::vector<std::string>& all) {
               options.set.insert(options.set.end(), all.begin(), all.end());
           },
           text("NOME=VALORE: mette un cursore della lezione; un nome sbagliato li elenca",
                "NAME=VALUE: puts a slider of the lesson; a wrong name lists them"))
        ->expected(1)
        ->take_all();
    add("--frames", "N: disegna N immagini e ne misura il tempo", "N: draws N frames and times them",
        [&options](const std::string& value) {
            options.frames = number<int>(value).value_or(0);
            if (options.frames < 1 || options.frames > 1'000'000)
                throw CLI::ValidationError("--frames", "expected a whole number from 1 to 1000000, found '" +
                                                           value + "'");
        });
}

void addFiles(CLI::App& app, Options& options) {
    const auto notEmpty = [](const std::string& option) {
        return CLI::Validator(
            [option](const std::string& value) {
                return value.empty() ? "expected a file name after " + option + ", found an empty one"
                                     : std::string();
            },
            "");
    };
    const auto add = [&](const std::string& name, std::string& into, const char* it, const char* en) {
        app.add_option(name, into, text(it, en))->check(notEmpty(name));
    };
    add("--frame", options.frame,
        "FILE: disegna un'immagine senza finestra (.png, o .exr e .pfm in virgola mobile) ed esce",
        "FILE: draws one frame without a window (.png, or .exr and .pfm in floats) and leaves");
    add("--frames-from", options.framesFrom,
        "FILE: un'immagine per ogni riga di opzioni del file, - per stdin; ogni riga ha il suo --frame",
        "FILE: a frame for each line of options in it, - for stdin; each line has a --frame of its own");
    add("--dump-scene", options.dumpScene, "FILE: scrive la scena come JSON di three.js",
        "FILE: writes the scene as three.js JSON");
    add("--state", options.state, "FILE: comincia dallo stato salvato con S o F2",
        "FILE: starts from the state that S or F2 saved");
    add("--shaders", options.shaders,
        "DIR: gli shader di questa cartella al posto di quelli del laboratorio con lo stesso nome",
        "DIR: the shaders of this folder in place of the lab's of the same name");
}

void addSwitches(CLI::App& app, Options& options) {
    for (const Switch& row : switchTable()) {
        const auto read = [&options, &row](const std::string& value) {
            if (!row.choose(value, options.switches))
                throw CLI::ValidationError(row.option, "expected " + row.names() + ", found '" + value + "'");
        };
        app.add_option_function<std::string>(row.option, read,
                                             row.names() + ": " + say(row.what, descriptions));
    }
}

void addChoices(CLI::App& app, Options& options) {
    const Adder add{app};
    add("--terms", "all, none, nomi da tenere, o +nome,-nome per cambiare",
        "all, none, names to keep, or +name,-name to change", [&options](const std::string& value) {
            try {
                options.switches.terms = lighting::parseTerms(value, lighting::TermSet::all());
            } catch (const std::invalid_argument& error) {
                throw CLI::ValidationError("--terms", error.what());
            }
        });
    add("--presenter", "[N]: caratteri grandi per il proiettore, N da 16 a 48 (28)",
        "[N]: large type for a projector, N from 16 to 48 (28)",
        [&options](const std::string& value) {
            options.fontSize =
                value.empty() ? 28 : checked("--presenter", [&] { return readNumber(value, 16, 48); });
        })
        ->expected(0, 1);
    add("--theme", "dark o light: il tema chiaro, per proiettori deboli",
        "dark or light: the light theme is for weak projectors",
        [&options](const std::string& value) { options.lightTheme = value == "light"; })
        ->check(CLI::IsMember({"dark", "light"}));
    add("--lang", "it o en", "it or en", [&options](const std::string& value) {
        options.language = value == "it" ? Language::it : Language::en;
    })->check(CLI::IsMember({"it", "en"}));
    add("--renderer",
        "gl: la scheda grafica; reference: il calcolo di riferimento in doppia precisione, "
        "senza scheda né schermo",
        "gl: the graphics driver; reference: the double-precision evaluation itself, "
        "no driver or display needed",
        [&options](const std::string& value) {
            if (value != "gl" && value != "reference")
                throw CLI::ValidationError("--renderer", "expected gl or reference, found '" + value + "'");
            options.renderer = value == "gl" ? RendererKind::gl : RendererKind::reference;
        });
}

// What only becomes a value after all words are read.
struct Flags {
    bool list = false;
    bool noSkip = false;
};

void addAll(CLI::App& app, Options& options, Flags& flags) {
    app.set_version_flag("--version", options.lesson + " " LAMBERT_VERSION,
                         text("dice la versione", "tells the version"));
    app.set_help_flag("--help,-h", text("questo aiuto", "this help"));
    addFiles(app, options);
    addNumbers(app, options);
    addChoices(app, options);
    addSwitches(app, options);
    app.add_flag("--no-skip", flags.noSkip, text("non tralascia nulla", "leaves nothing out"));
    app.add_flag("--stats", options.stats,
                 text("scrive una riga JSON con tempi e conteggi", "writes a JSON line of times and counts"));
    app.add_flag("--dump-shader", options.dumpShader,
                 text("scrive gli shader come vengono compilati", "writes the shaders as compiled"));
    app.add_flag("--list-terms", flags.list,
                 text("elenca i termini dell'equazione", "lists the equation's terms"));
}

// CLI11 takes the last word first.
void parse(CLI::App& app, std::span<const std::string> words) {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
}

}  // namespace

std::pair<int, int> readSize(std::string_view text) {
    const std::size_t x = text.find('x');
    const std::optional<int> width = number<int>(text.substr(0, x));
    const std::optional<int> height = x == std::string::npos ? std::nullopt : number<int>(text.substr(x + 1));
    if (!width || !height || *width < 1 || *height < 1 || *width > largestSize || *height > largestSize)
        throw UsageError("expected WIDTHxHEIGHT, each from 1 to 8192 pixels, found '" + std::string(text) +
                         "'");
    return {*width, *height};
}

CameraOption readCamera(std::string_view text) {
    const std::vector<double> values = readNumbers(text, 1, 100);
    if (values.size() != 6 && values.size() != 7)
        throw UsageError("expected px,py,pz,tx,ty,tz or, with the angle of view, one number more; found " +
                         std::to_string(values.size()) + " in '" + std::string(text) + "'");
    CameraOption camera{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}, {}};
    if (values.size() == 7) {
        if (!(values[6] > 0 && values[6] < 180))
            throw UsageError("expected an angle of view between 0 and 180 degrees, found '" +
                             std::string(text) + "'");
        camera.fov = values[6];
    }
    if (std::equal(camera.position, camera.position + 3, camera.target))
        throw UsageError("expected two different points, found the same twice in '" + std::string(text) +
                         "'");
    return camera;
}

bool flushOutput(const std::string& who) {
    if (std::cout.flush())
        return true;
    std::cerr << who << ": cannot write to standard output; free space there, or send it elsewhere\n";
    return false;
}

Language languageOfLocale() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
            return std::string_view(value).substr(0, 2) == "it" ? Language::it : Language::en;
    return Language::en;
}

std::variant<Options, Ending> parseOptions(std::span<const std::string> arguments, const std::string& lesson,
                                           bool file) {
    Options options;
    options.lesson = lesson;
    options.language = descriptions = languageOf(arguments);
    CLI::App app(lesson + ", Lambert Lab " LAMBERT_VERSION, lesson);
    Flags flags;
    addAll(app, options, flags);
    if (file)
        app.add_option("file", options.sceneFile,
                       text("scena three.js (JSON) o .obj", "three.js scene (JSON) or .obj"));
    for (const char* one : {"--frame", "--frames", "--dump-scene", "--dump-shader"})
        app.get_option("--frames-from")->excludes(app.get_option(one));
    const auto wrong = [&lesson](const std::string& what) {
        return Ending{2, "", lesson + ": " + what + "\nSee " + lesson + " --help for what is understood.\n"};
    };
    try {
        parse(app, arguments);
    } catch (const CLI::Success& asked) {
        std::ostringstream out;
        app.exit(asked, out, out);
        return Ending{0, out.str(), ""};
    } catch (const CLI::ParseError& error) {
        return wrong(error.what());
    }
    options.skip = !flags.noSkip;
    if (flags.list)
        return Ending{0, listTerms(options.language), ""};
    if (file && options.sceneFile.empty())
        return wrong("expected a scene file (three.js JSON or .obj), found none");
    return options;
}

Options parseFrameLine(std::span<const std::string> words, const Options& commandLine) {
    Options options = commandLine;
    options.framesFrom.clear();
    CLI::App app;
    Flags flags;
    addAll(app, options, flags);
    const auto refuse = [](const std::string& option) {
        throw UsageError("found " + option +
                         ", which is not about one frame; expected it on the command line "
                         "or nowhere; take it out of this line");
    };
    try {
        parse(app, words);
    } catch (const CLI::Success&) {
        refuse("--help or --version");
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    for (const char* other : {"--frames-from", "--frames", "--dump-scene", "--dump-shader", "--list-terms"})
        if (app.count(other) > 0)
            refuse(other);
    if (options.frame.empty())
        throw UsageError(
            "expected --frame FILE among the options of this line, found none; add where to write");
    options.skip = commandLine.skip && !flags.noSkip;
    return options;
}

Options readOptions(int argc, char** argv, const std::string& lesson, bool file) {
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    std::variant<Options, Ending> parsed = parseOptions(arguments, lesson, file);
    if (Options* const options = std::get_if<Options>(&parsed))
        return std::move(*options);
    const Ending& ending = std::get<Ending>(parsed);
    std::cout << ending.out;
    std::cerr << ending.err;
    std::exit(flushOutput(lesson) ? ending.status : 5);
}

}  // namespace lab
