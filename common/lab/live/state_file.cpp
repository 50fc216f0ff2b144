// States to JSON and back.
// SPDX-License-Identifier: MIT
#include "lab/live/state_file.hpp"

#include "lab/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

namespace lab {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;  // of these files
constexpr int largestSize = 8192;
constexpr std::uintmax_t largestFile = 1 << 20;

std::string readAll(const std::string& file) {
    std::error_code error;
    const auto cannot = [&file](const std::string& why) {
        return UsageError("--state: cannot read '" + file + "': " + why +
                          "; expected a file that S or F2 saved in a lesson's window");
    };
    if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
        throw cannot("it is no file");
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw cannot(std::generic_category().message(errno != 0 ? errno : EIO));
    if (std::filesystem::file_size(file, error) > largestFile)
        throw cannot("it is larger than 1 MiB");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

std::string stateText(const SavedState& state, bool oneLine) {
    Json json;
    json["lambert_lab"] = format;
    json["program"] = state.program;
    if (!state.sceneFile.empty())
        json["scene"] = state.sceneFile;
    json["size"] = {state.width, state.height};
    json["controls"] = Json::object();
    for (const auto& [name, value] : state.controls)
        json["controls"][name] = value;
    return json.dump(oneLine ? -1 : 2, ' ', false, Json::error_handler_t::replace) + (oneLine ? "" : "\n");
}

SavedState readState(const std::string& file, const std::string& program) {
    const Json json = Json::parse(readAll(file), nullptr, false);
    const auto wrong = [&file](const std::string& field, const std::string& expected, const Json& found) {
        return UsageError(file + ": " + field + ": expected " + expected + ", found " +
                          found.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60) +
                          "; is this a file that S or F2 saved?");
    };
    if (json.is_discarded() || !json.is_object())
        throw UsageError(
            file + ": expected a JSON object, found something else; is this a file that S or F2 saved?");
    const auto at = [&json](const char* name) { return json.contains(name) ? json[name] : Json(); };
    if (at("lambert_lab") != format)
        throw wrong("lambert_lab", std::to_string(format), at("lambert_lab"));
    if (at("program") != program)
        throw wrong("program", "\"" + program + "\", which is this program", at("program"));
    SavedState state;
    state.program = program;
    const Json size = at("size");
    const auto isSide = [](const Json& n) { return n.is_number_integer() && n >= 1 && n <= largestSize; };
    if (!size.is_array() || size.size() != 2 || !isSide(size[0]) || !isSide(size[1]))
        throw wrong("size", "[width, height], each from 1 to 8192", size);
    state.width = size[0];
    state.height = size[1];
    const Json controls = at("controls");
    if (!controls.is_object())
        throw wrong("controls", "an object of names and texts", controls);
    for (const auto& [name, value] : controls.items()) {
        if (!value.is_string())
            throw wrong("controls: " + name, "a text", value);
        state.controls[name] = value;
    }
    return state;
}

void takeStateSize(Options& options) {
    if (options.state.empty() || options.width)
        return;
    const SavedState state = readState(options.state, options.lesson);
    options.width = state.width;
    options.height = state.height;
}

std::string freeName(const std::string& base, const std::vector<std::string>& extensions) {
    const auto taken = [&extensions](const std::string& name) {
        return std::any_of(extensions.begin(), extensions.end(), [&name](const std::string& extension) {
            std::error_code ignored;
            return std::filesystem::exists(name + extension, ignored);
        });
    };
    std::string name = base;
    for (int number = 1; taken(name); ++number)
        name = base + "-" + std::to_string(number);
    return name;
}

}  // namespace lab
