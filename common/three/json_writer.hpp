// JSON text, piece by piece: readable indentation, numbers that read back as the same doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace THREE {

/// Writes values in order. Inside an object every value follows a key(); arrays of numbers stay on one line.
class JsonWriter {
  public:
    JsonWriter& beginObject() { return open('{'); }
    JsonWriter& endObject() { return close('}'); }
    JsonWriter& beginArray() { return open('['); }
    JsonWriter& endArray() { return close(']'); }
    JsonWriter& key(std::string_view name);
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(bool flag);
    /// The shortest decimal that reads back as the same double. Throws SceneError naming `whose` for NaN and infinity,
    /// which JSON cannot say.
    JsonWriter& value(double number);
    JsonWriter& value(const std::vector<double>& numbers);
    JsonWriter& value(const std::vector<std::uint32_t>& numbers);
    template <class T>
    JsonWriter& field(std::string_view name, const T& content) {
        return key(name).value(content);
    }

    /// Names what is being written. Called for the message about NaN only: to look for the name among thousands of siblings
    /// takes time.
    std::function<std::string()> whose;
    /// Everything written so far.
    const std::string& text() const { return text_; }

  private:
    JsonWriter& open(char bracket);
    JsonWriter& close(char bracket);
    void separate();
    void append(double number);

    std::string text_;
    std::string key_;  // the latest, for the message about NaN
    int depth_ = 0;
    bool first_ = true;  // nothing in the innermost container yet
    bool afterKey_ = false;
};

}  // namespace THREE
