// libFuzzer's mutations for JSON: values, keys and whole branches change, so that most inputs get past the parser.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

using nlohmann::json;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

class Mutator {
  public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_()) % end; }

    void mutate(json& document) {
        collect(document);
        json& chosen = *values_[below(values_.size())];
        switch (below(4)) {
        case 0: {  // a branch takes the place of another one
            const json copy = *values_[below(values_.size())];
            chosen = copy;
            break;
        }
        case 1:
            lose(chosen);
            break;
        case 2: {  // a key under another name, or a value under a key from elsewhere
            if (!keys_.empty() && chosen.is_object() && !chosen.empty())
                chosen[keys_[below(keys_.size())]] = json(element(chosen));
            else
                change(chosen);
            break;
        }
        default:
            change(chosen);
        }
    }

  private:
    void collect(json& value) {
        values_.push_back(&value);
        if (value.is_object())
            for (const auto& field : value.items())
                keys_.push_back(field.key());
        if (value.is_structured())
            for (json& part : value)
                collect(part);
    }

    json& element(json& container) {
        auto place = container.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(below(container.size())));
        return *place;
    }

    void lose(json& value) {
        if (!value.is_structured() || value.empty()) {
            value = nullptr;
            return;
        }
        auto place = value.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(below(value.size())));
        value.erase(place);
    }

    void change(json& value) {
        if (value.is_boolean())
            value = !value.get<bool>();
        else if (value.is_array() && !value.empty())
            value.push_back(json(element(value)));
        else
            value = number(value.is_number() ? value.get<double>() : 1);
    }

    double number(double old) {
        static const double special[] = {0,        -0.0,   1,     2,     3,      180,
                                         1e3,      1e36,   1e37,  1e18,  1e20,   1e24,
                                         16777215, 5e-324, 1e-30, 1e-18, 1e-300, 4294967295};
        const double sign = below(4) == 0 ? -1 : 1;
        switch (below(4)) {
        case 0:
            return sign * special[below(std::size(special))];
        case 1:
            return sign * std::ldexp(old, static_cast<int>(below(240)) - 120);
        case 2:
            return old + sign;
        default: {  // any double of any size
            const std::uint64_t high = random_();
            const auto any = std::bit_cast<double>(high << 32U | random_());
            return std::isfinite(any) ? any : old / 2;
        }
        }
    }

    std::mt19937 random_;
    std::vector<json*> values_;
    std::vector<std::string> keys_;
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
    Mutator mutator(seed);
    const auto brackets = std::count(data, data + size, '[') + std::count(data, data + size, '{');
    // Deeper texts would take more stack here than a loader may use.
    json document =
        brackets > 1000 ? json(json::value_t::discarded) : json::parse(data, data + size, nullptr, false);
    if (document.is_discarded() || mutator.below(4) == 0)
        return LLVMFuzzerMutate(data, size, maxSize);
    mutator.mutate(document);
    const std::string text = document.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > maxSize)
        return LLVMFuzzerMutate(data, size, maxSize);
    std::copy(text.begin(), text.end(), data);
    return text.size();
}
