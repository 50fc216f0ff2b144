// A JSON value that knows where it stands, so that every refusal can name its path.
// SPDX-License-Identifier: MIT
#include "three/json_node.hpp"

#include "three/scene_file.hpp"

#include <cmath>

namespace THREE {

using nlohmann::json;

std::string shortly(const json& value) {
    switch (value.type()) {
    case json::value_t::null:
        return "null (JSON writes NaN and Infinity so)";
    case json::value_t::object:
        return "an object";
    case json::value_t::array:
        return "an array of " + std::to_string(value.size());
    case json::value_t::string:
        return std::string("\"").append(printable(value.get_ref<const std::string&>())).append("\"");
    case json::value_t::boolean:
        return value.get<bool>() ? "true" : "false";
    default:
        return "the number " + value.dump();
    }
}

std::optional<Node> Node::find(const char* key) const {
    const auto field = object().value_->find(key);
    if (field == value_->end())
        return std::nullopt;
    return Node(*field, path_.empty() ? key : path_ + "." + key, *file_);
}

std::optional<Node> Node::findSet(const char* key) const {
    std::optional<Node> field = find(key);
    return field && !field->value_->is_null() ? field : std::nullopt;
}

Node Node::at(const std::string& key, const char* expected) const {
    const auto field = object().value_->find(key);
    const std::string path = path_.empty() ? key : path_ + "." + printable(key);
    if (field == value_->end())
        throw SceneError(*file_ + ": " + path + ": expected " + expected +
                         ", found nothing; add the field or export the scene again");
    return Node(*field, path, *file_);
}

Node Node::at(std::size_t element) const {
    return Node((*value_)[element], path_ + "[" + std::to_string(element) + "]", *file_);
}

const Node& Node::object() const {
    if (!value_->is_object())
        fail("an object");
    return *this;
}

const Node& Node::array() const {
    if (!value_->is_array())
        fail("an array");
    return *this;
}

double Node::number() const {
    if (!value_->is_number())
        fail("a number");
    const double x = value_->get<double>();
    if (!(std::abs(x) <= largestNumber))
        fail("a number of at most 1e36", "scale the scene down");
    return x;
}

double Node::number(const char* key, double otherwise) const {
    const std::optional<Node> field = find(key);
    return field ? field->number() : otherwise;
}

std::int64_t Node::whole(std::int64_t lowest, std::int64_t highest) const {
    const double x = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(x == std::floor(x) && x >= static_cast<double>(lowest) && x <= static_cast<double>(highest)))
        fail("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return static_cast<std::int64_t>(x);
}

std::int64_t Node::whole(const char* key, std::int64_t otherwise, std::int64_t lowest,
                         std::int64_t highest) const {
    const std::optional<Node> field = find(key);
    return field ? field->whole(lowest, highest) : otherwise;
}

bool Node::boolean(const char* key, bool otherwise) const {
    const std::optional<Node> field = find(key);
    if (!field)
        return otherwise;
    if (!field->value_->is_boolean())
        field->fail("true or false");
    return field->value_->get<bool>();
}

std::string Node::text() const {
    if (!value_->is_string())
        fail("a text");
    return value_->get<std::string>();
}

std::string Node::text(const char* key, const std::string& otherwise) const {
    const std::optional<Node> field = find(key);
    return field ? field->text() : otherwise;
}

std::vector<double> Node::numbers(std::size_t count) const {
    if (array().size() != count)
        fail("an array of " + std::to_string(count) + " numbers");
    std::vector<double> all(count);
    for (std::size_t i = 0; i < count; ++i)
        all[i] = at(i).number();
    return all;
}

Color Node::color(const char* key, const char* exactKey, const Color& otherwise) const {
    const std::optional<Node> code = find(key);
    if (!code)
        return otherwise;
    if (!code->value_->is_number())
        code->fail("a colour as the number 0xRRGGBB in decimal", "orange, 0xff8855, is 16746581");
    const auto hex = static_cast<std::uint32_t>(code->whole(0, 0xFFFFFF));
    if (const std::optional<Node> exact = find(exactKey)) {
        const std::vector<double> rgb = exact->numbers(3);
        const Color color(rgb[0], rgb[1], rgb[2]);
        if (color.getHex() == hex)  // else somebody has edited the code since, and that is what counts
            return color;
    }
    return Color(hex);
}

void Node::fail(const std::string& expected, const std::string& hint) const {
    refuse("expected " + expected + ", found " + shortly(*value_) + (hint.empty() ? "" : "; " + hint));
}

void Node::refuse(const std::string& what) const {
    throw SceneError(*file_ + ": " + (path_.empty() ? "" : path_ + ": ") + what);
}

void Node::unsupported(const std::string& what) const {
    throw Unsupported(*file_ + ": " + (path_.empty() ? "" : path_ + ": ") + what);
}

}  // namespace THREE
