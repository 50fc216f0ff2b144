// Reads slides_refs/misconceptions.json, and says where it is wrong.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/texts.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace grader {

namespace {

using nlohmann::json;

// A value with its place in the file, for messages.
class Node {
  public:
    Node(const json& value, std::string place) : value_(value), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& expected) const {
        const std::string found = value_.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 60);
        throw std::runtime_error(place_ + ": expected " + expected + ", found " + found);
    }

    bool has(const char* field) const { return value_.contains(field) && !value_[field].is_null(); }

    Node at(const char* field) const {
        if (!value_.is_object() || !value_.contains(field))
            fail(std::string("an object with \"") + field + '"');
        return {value_[field], place_ + "." + field};
    }

    std::string text() const {
        if (!value_.is_string() || value_.get_ref<const std::string&>().empty())
            fail("a text that is not empty");
        return value_;
    }

    BothLanguages both() const { return {at("it").text(), at("en").text()}; }

    std::vector<Node> list() const {
        if (!value_.is_array() || value_.empty())
            fail("a list that is not empty");
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < value_.size(); ++i)
            nodes.emplace_back(value_[i], place_ + "[" + std::to_string(i) + "]");
        return nodes;
    }

    int number() const {
        if (!value_.is_number_integer())
            fail("a slide's number");
        return value_;
    }

    std::vector<int> numbers() const {
        std::vector<int> all;
        for (const Node& node : list())
            all.push_back(node.number());
        return all;
    }

  private:
    const json& value_;
    std::string place_;
};

json parse(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in)
        throw std::runtime_error(file.string() +
                                 ": expected a file of texts there, found none that can be read");
    try {
        return json::parse(in);
    } catch (const json::parse_error& e) {
        throw std::runtime_error(file.string() + ": expected JSON: " + e.what());
    }
}

CheckText readCheck(const Node& node) {
    return {node.at("id").text(), node.at("slides").numbers(), node.at("title").both(),
            node.at("expected").both()};
}

// What a misconception and a class have in common.
MisconceptionText readText(const Node& node, std::vector<std::string> ids) {
    MisconceptionText text;
    text.ids = std::move(ids);
    text.check = node.at("check").text();
    text.name = node.at("name").both();
    text.hint = node.at("hint").both();
    if (node.has("why"))
        text.why = node.at("why").text();
    return text;
}

MisconceptionText readMisconception(const Node& node) {
    MisconceptionText text = readText(node, {node.at("id").text()});
    text.slides = node.at("slides").numbers();
    const Node convention = node.at("convention");
    if (node.has("convention"))
        text.convention = convention.both();
    return text;
}

MisconceptionText readClass(const Node& node, const Texts& texts) {
    std::vector<std::string> ids;
    for (const Node& id : node.at("ids").list())
        ids.push_back(id.text());
    MisconceptionText text = readText(node, ids);
    text.slides = texts.misconception(ids.front()).slides;
    return text;
}

[[noreturn]] void refuse(const std::string& id) {
    throw std::out_of_range("the grader's texts (misconceptions.json) have none for '" + id + "'");
}

}  // namespace

Texts::Texts(const std::filesystem::path& file) {
    const json data = parse(file);
    const Node root(data, file.string() + ": $");
    std::set<std::string> known;
    for (const Node& node : root.at("checks").list()) {
        checks_.push_back(readCheck(node));
        if (!known.insert(checks_.back().id).second)
            node.at("id").fail("an id of its own");
    }
    const auto requireKnown = [&](const Node& node, const MisconceptionText& text) {
        if (!known.contains(text.check))
            node.at("check").fail("the id of one of the checks");
    };
    std::set<std::string> ids;
    for (const Node& node : root.at("misconceptions").list()) {
        misconceptions_.push_back(readMisconception(node));
        requireKnown(node, misconceptions_.back());
        if (!ids.insert(misconceptions_.back().ids.front()).second)
            node.at("id").fail("an id of its own");
    }
    for (const Node& node : root.at("classes").list()) {
        classes_.push_back(readClass(node, *this));
        requireKnown(node, classes_.back());
    }
}

const MisconceptionText& Texts::misconception(const std::string& id) const {
    for (const MisconceptionText& text : misconceptions_)
        if (text.ids.front() == id)
            return text;
    refuse(id);
}

const CheckText& Texts::check(const std::string& id) const {
    for (const CheckText& text : checks_)
        if (text.id == id)
            return text;
    refuse(id);
}

const MisconceptionText& Texts::textOf(const std::vector<std::string>& ids) const {
    if (ids.size() == 1)
        return misconception(ids.front());
    const std::set<std::string> wanted(ids.begin(), ids.end());
    for (const MisconceptionText& text : classes_)
        if (std::set<std::string>(text.ids.begin(), text.ids.end()) == wanted)
            return text;
    std::string all;
    for (const std::string& id : ids)
        all += (all.empty() ? "" : " ") + id;
    refuse(all);
}

}  // namespace grader
