// JSON text, piece by piece: readable indentation, numbers that read back as the same doubles.
// SPDX-License-Identifier: MIT
#include "three/json_writer.hpp"

#include "three/validate.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace THREE {

namespace {

// Bytes that are no UTF-8 become U+FFFD: a name is never worth failing for.
std::string quoted(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void JsonWriter::separate() {
    if (afterKey_) {
        afterKey_ = false;
        return;
    }
    if (!first_)
        text_ += ',';
    if (depth_ > 0) {
        text_ += '\n';
        text_.append(static_cast<std::size_t>(depth_), ' ');
    }
    first_ = false;
}

JsonWriter& JsonWriter::open(char bracket) {
    separate();
    text_ += bracket;
    ++depth_;
    first_ = true;
    return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
    --depth_;
    if (!first_) {
        text_ += '\n';
        text_.append(static_cast<std::size_t>(depth_), ' ');
    }
    text_ += bracket;
    first_ = false;
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    separate();
    key_ = name;
    text_ += quoted(name) + ": ";
    afterKey_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
    separate();
    text_ += quoted(text);
    return *this;
}

JsonWriter& JsonWriter::value(bool flag) {
    separate();
    text_ += flag ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::value(double number) {
    separate();
    append(number);
    return *this;
}

JsonWriter& JsonWriter::value(const std::vector<double>& numbers) {
    separate();
    text_ += '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0)
            text_ += ',';
        append(numbers[i]);
    }
    text_ += ']';
    return *this;
}

JsonWriter& JsonWriter::value(const std::vector<std::uint32_t>& numbers) {
    separate();
    text_ += '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0)
            text_ += ',';
        text_ += std::to_string(numbers[i]);
    }
    text_ += ']';
    return *this;
}

void JsonWriter::append(double number) {
    if (!std::isfinite(number))
        throw SceneError(whose() + ": " + key_ + ": expected a finite number, found " +
                         (std::isnan(number) ? "NaN" : "infinity") +
                         ", which JSON cannot say; correct it first");
    if (number == 0 && std::signbit(number)) {  // "-0" would be read as the integer 0
        text_ += "-0.0";
        return;
    }
    const double size = std::abs(number);
    const bool isOrdinary = number == 0 || (size >= 1e-5 && size < 1e15);
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, number,
                                   isOrdinary ? std::chars_format::fixed : std::chars_format::scientific);
    text_.append(digits, end.ptr);
}

}  // namespace THREE
