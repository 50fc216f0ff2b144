// A JSON value that knows where it stands, so that every refusal can name its path.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/color.hpp"
#include "three/validate.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace THREE {

/// Understood but not supported: the loader notes it where it cannot change the picture; else it is a SceneError.
class Unsupported : public SceneError {
  public:
    using SceneError::SceneError;
};

/// A value of the document with its path ("object.children[2].geometry") and its file's name. Refers to both.
class Node {
  public:
    Node(const nlohmann::json& value, std::string path, const std::string& file)
        : value_(&value), path_(std::move(path)), file_(&file) {}

    const nlohmann::json& value() const { return *value_; }
    const std::string& path() const { return path_; }

    /// The field, if there is one; it may be null.
    std::optional<Node> find(const char* key) const;
    /// The field, if there is one and it is not null.
    std::optional<Node> findSet(const char* key) const;
    /// The field; refused if missing, as "expected <expected>, found nothing".
    Node at(const std::string& key, const char* expected) const;
    /// An element of an array; must exist.
    Node at(std::size_t element) const;
    std::size_t size() const { return value_->size(); }

    /// Refused unless it is an object (array).
    const Node& object() const;
    const Node& array() const;
    /// A number of at most 1e36.
    double number() const;
    double number(const char* key, double otherwise) const;
    /// A whole number in [lowest, highest].
    std::int64_t whole(std::int64_t lowest, std::int64_t highest) const;
    std::int64_t whole(const char* key, std::int64_t otherwise, std::int64_t lowest,
                       std::int64_t highest) const;
    bool boolean(const char* key, bool otherwise) const;
    std::string text() const;
    std::string text(const char* key, const std::string& otherwise) const;
    /// An array of exactly `count` numbers.
    std::vector<double> numbers(std::size_t count) const;
    /// three.js's 0xRRGGBB under `key`, or the three exact doubles under `exactKey` if they mean that same code: toJSON
    /// writes both where a colour is no multiple of 1/255.
    Color color(const char* key, const char* exactKey, const Color& otherwise) const;

    /// "file: path: expected <expected>, found <this value>"; a hint may follow.
    [[noreturn]] void fail(const std::string& expected, const std::string& hint = "") const;
    /// "file: path: <what>".
    [[noreturn]] void refuse(const std::string& what) const;
    /// The same, as Unsupported.
    [[noreturn]] void unsupported(const std::string& what) const;

  private:
    const nlohmann::json* value_;
    std::string path_;
    const std::string* file_;
};

/// A short name of a value for messages: "the number 3", "\"abc\"", "an array of 4".
std::string shortly(const nlohmann::json& value);

}  // namespace THREE
