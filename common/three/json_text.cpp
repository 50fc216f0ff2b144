// JSON text to a tree of values, with errors that name line and column.
// SPDX-License-Identifier: MIT
#include "three/json_text.hpp"

#include "three/scene_file.hpp"
#include "three/validate.hpp"

#include <vector>

namespace THREE {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& text, const std::string& file, std::size_t byte,
                         const std::string& why) {
    throw SceneError(file + ": " + placeIn(text, byte) + ": " + why);
}

// Depth and NUL bytes first, on the plain text: both would otherwise be found too late (the parser takes a NUL for
// the end of the file) or without a place.
void checkBytes(const std::string& text, const std::string& file) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\0')
            refuse(text, file, i,
                   "expected JSON text, found a NUL byte; is this a binary file? Export it as three.js JSON");
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"')
            inString = true;
        else if (c == '[' || c == '{') {
            if (++depth > deepestJson)
                refuse(text, file, i,
                       "expected brackets at most " + std::to_string(deepestJson) +
                           " deep, found one more; flatten the scene");
        } else if (c == ']' || c == '}')
            --depth;
    }
}

// Builds the tree as the parser meets the values. Pointers into open containers stay good, because only the innermost
// open one grows.
class Builder final : public nlohmann::json_sax<json> {
  public:
    Builder(const std::string& text, const std::string& file) : text_(text), file_(file) {}
    json root;

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        json& object = *open_.back();
        const auto [place, isNew] = object.get_ptr<json::object_t*>()->emplace(std::move(name), nullptr);
        slots_.back() = &place->second;
        keys_.back() = place->first;
        if (!isNew)
            throw SceneError(file_ + ": " + path() +
                             ": expected each key once in an object, found it twice; remove one of them");
        return true;
    }

    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& e) override {
        // The library's text begins with its own code and place; what follows the last of them is the reason.
        std::string why = e.what();
        const std::size_t place = why.find(": ");
        why = place == std::string::npos ? why : why.substr(place + 2);
        if (const std::size_t code = why.find("] "); why.starts_with('[') && code != std::string::npos)
            why = why.substr(code + 2);
        refuse(text_, file_, byte == 0 ? 0 : byte - 1,
               "expected JSON, found " + printable(why, 200) +
                   "; is the file complete? Write it again with JSON.stringify(scene.toJSON())");
    }

  private:
    template <class T>
    json* add(T&& value) {
        if (open_.empty()) {
            root = std::forward<T>(value);
            return &root;
        }
        json& parent = *open_.back();
        if (parent.is_array()) {
            auto& array = *parent.get_ptr<json::array_t*>();
            array.emplace_back(std::forward<T>(value));
            return &array.back();
        }
        *slots_.back() = std::forward<T>(value);
        return slots_.back();
    }
    template <class T>
    bool put(T&& value) {
        add(std::forward<T>(value));
        return true;
    }
    bool open(json container) {
        open_.push_back(add(std::move(container)));
        slots_.push_back(nullptr);
        keys_.emplace_back();
        return true;
    }
    bool close() {
        open_.pop_back();
        slots_.pop_back();
        keys_.pop_back();
        return true;
    }
    std::string path() const {
        std::string where;
        for (std::size_t i = 0; i < open_.size(); ++i)
            if (open_[i]->is_array())
                where += "[" + std::to_string(open_[i]->size() - 1) + "]";
            else
                where += (where.empty() ? "" : ".") + printable(keys_[i]);
        return printable(where, 400);
    }

    const std::string& text_;
    const std::string& file_;
    std::vector<json*> open_;  // containers from the root to the innermost
    std::vector<json*> slots_;  // for each open object, where its next value goes
    std::vector<std::string> keys_;  // for each open object, its latest key
};

}  // namespace

json parseJsonText(const std::string& text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw SceneError(file + ": expected a scene, found an empty file; save or export it again");
    checkBytes(text, file);
    Builder builder(text, file);
    json::sax_parse(text, &builder);
    return std::move(builder.root);
}

}  // namespace THREE
