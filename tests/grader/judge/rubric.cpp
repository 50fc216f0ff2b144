// Rubrics from JSON, each field checked.
// SPDX-License-Identifier: MIT
#include "grader/judge/rubric.hpp"

#include "grader/submission/hash.hpp"

#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace grader {

namespace {

using Json = nlohmann::json;

constexpr const char* schema = "lambert-lab/rubric/1";
constexpr int mostViews = 16;

// A field of the file, which knows its place for messages.
class Node {
  public:
    Node(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

    [[noreturn]] void refuse(const std::string& expected) const {
        std::string found = json_.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60);
        throw std::runtime_error(place_ + ": expected " + expected + ", found " + found);
    }
    /// Every key of the object is one of these: a misspelt one would be without effect.
    void only(std::initializer_list<const char*> names) const {
        if (!json_.is_object())
            refuse("an object");
        const std::set<std::string> known(names.begin(), names.end());
        for (const auto& [key, value] : json_.items())
            if (known.count(key) == 0)
                Node(value, place_ + "." + key).refuse("no such field");
    }
    bool has(const char* name) const { return json_.contains(name); }
    Node at(const char* name) const {
        if (!json_.is_object() || !json_.contains(name))
            throw std::runtime_error(place_ + ": expected a field \"" + name + "\", found none");
        return {json_[name], place_ + "." + name};
    }
    std::string text() const {
        if (!json_.is_string() || json_.get_ref<const std::string&>().empty())
            refuse("a text");
        return json_;
    }
    double number(double low, double high) const {
        if (!json_.is_number() || !(json_.get<double>() >= low && json_.get<double>() <= high))
            refuse("a number from " + Json(low).dump() + " to " + Json(high).dump());
        return json_;
    }
    int integer(int low, int high) const {
        if (!json_.is_number_integer())
            refuse("a whole number");
        return static_cast<int>(number(low, high));
    }
    std::uint64_t seed() const {
        if (!json_.is_number_unsigned())
            refuse("a whole number that is not negative");
        return json_;
    }
    bool flag() const {
        if (!json_.is_boolean())
            refuse("true or false");
        return json_;
    }
    BothLanguages words() const {
        only({"it", "en"});
        return {at("it").text(), at("en").text()};
    }
    template <class Make>
    auto list(const Make& make) const {
        if (!json_.is_array())
            refuse("a list");
        std::vector<decltype(make(*this))> all;
        for (std::size_t i = 0; i < json_.size(); ++i)
            all.push_back(make(Node(json_[i], place_ + "[" + std::to_string(i) + "]")));
        return all;
    }
    std::vector<std::string> texts() const {
        return list([](const Node& one) { return one.text(); });
    }
    template <std::size_t n>
    std::array<double, n> numbers(double low, double high) const {
        const auto all = list([&](const Node& one) { return one.number(low, high); });
        if (all.size() != n)
            refuse(std::to_string(n) + " numbers");
        std::array<double, n> result{};
        std::copy(all.begin(), all.end(), result.begin());
        return result;
    }
    std::map<std::string, double> shares() const {
        std::map<std::string, double> all;
        if (!json_.is_object())
            refuse("an object of misconceptions and what is left, from 0 to 1");
        for (const auto& [key, value] : json_.items())
            all[key] = Node(value, place_ + "." + key).number(0, 1);
        return all;
    }

  private:
    const Json& json_;
    std::string place_;
};

StepCheck stepCheck(const Node& node) {
    node.only({"id", "slides", "points", "new", "title", "expected", "aspects", "keeps", "variants"});
    StepCheck check;
    check.id = node.at("id").text();
    check.slides = node.at("slides").list([](const Node& one) { return one.integer(1, 999); });
    check.points = node.at("points").number(0, 1e6);
    check.isNew = node.at("new").flag();
    check.title = node.at("title").words();
    check.expected = node.at("expected").words();
    check.aspects = node.at("aspects").texts();
    if (node.has("keeps"))
        check.keeps = node.at("keeps").texts();
    if (node.has("variants"))
        check.variants = node.at("variants").texts();
    return check;
}

TermCheck termCheck(const Node& node) {
    node.only({"id", "points", "new", "credit"});
    TermCheck check;
    check.id = node.at("id").text();
    check.points = node.at("points").number(0, 1e6);
    check.isNew = node.at("new").flag();
    if (node.has("credit"))
        check.credit = node.at("credit").shares();
    return check;
}

Variant variant(const Node& node) {
    node.only({"id", "options", "lamp"});
    Variant result;
    result.id = node.at("id").text();
    result.options = node.at("options").texts();
    result.lamp = node.has("lamp") && node.at("lamp").flag();
    return result;
}

void readViews(const Node& views, Rubric& rubric) {
    views.only(
        {"count", "size", "seconds", "look_at", "distance", "azimuth_degrees", "height_degrees", "fov"});
    rubric.views = views.at("count").integer(1, mostViews);
    rubric.size = views.at("size").integer(32, 1024);
    rubric.seconds = views.at("seconds").number(0, 1e6);
    rubric.lookAt = views.at("look_at").numbers<3>(-1e6, 1e6);
    rubric.distance = views.at("distance").numbers<2>(1e-3, 1e6);
    if (views.has("azimuth_degrees"))
        rubric.azimuth = views.at("azimuth_degrees").numbers<2>(-360, 360);
    rubric.height = views.at("height_degrees").numbers<2>(-89, 89);
    rubric.fov = views.at("fov").number(1, 170);
}

void expectDifferentIds(const Node& root, const Rubric& rubric) {
    std::set<std::string> ids{"builds", "runs"};
    const auto once = [&](const std::string& id) {
        if (!ids.insert(id).second)
            throw std::runtime_error(root.at("lesson").text() + ": the check '" + id +
                                     "' is there twice, or has a name that the grader uses itself");
    };
    for (const StepCheck& check : rubric.steps)
        once(check.id);
    for (const TermCheck& check : rubric.terms)
        once(check.id);
}

Rubric fromJson(const Node& root) {
    root.only({"schema", "about", "lesson", "points", "seed", "requires", "views", "variants", "scenes",
               "steps", "terms"});
    if (root.at("schema").text() != schema)
        root.at("schema").refuse(std::string("\"") + schema + "\"");
    Rubric rubric;
    rubric.lesson = root.at("lesson").text();
    rubric.points = root.at("points").number(1, 1e6);
    rubric.seed = root.at("seed").seed();
    rubric.required = root.at("requires").texts();
    readViews(root.at("views"), rubric);
    rubric.variants = root.at("variants").list(variant);
    if (rubric.variants.empty())
        root.at("variants").refuse("at least one");
    const Node scenes = root.at("scenes");
    scenes.only({"count", "shiny"});
    rubric.scenes = scenes.at("count").integer(1, mostViews);
    rubric.shiny = scenes.at("shiny").flag();
    rubric.steps = root.at("steps").list(stepCheck);
    rubric.terms = root.at("terms").list(termCheck);
    expectDifferentIds(root, rubric);
    return rubric;
}

}  // namespace

Rubric Rubric::read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        throw std::runtime_error(file.string() +
                                 ": cannot be read; expected a rubric (lessons/*.rubric.json)");
    try {
        const Json json = Json::parse(text.str());
        Rubric rubric = fromJson(Node(json, file.filename().string()));
        rubric.hash = sha256(text.str());
        return rubric;
    } catch (const Json::parse_error& error) {
        throw std::runtime_error(file.string() + ": no JSON: " + error.what());
    }
}

}  // namespace grader
