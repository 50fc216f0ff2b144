// Controls: the numbers of a lesson that are moved by hand, and those that it reads off.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"

#include <deque>
#include <span>
#include <string>
#include <vector>

namespace lab {

/// A number that is moved by hand.
struct Slider {
    std::string name;  ///< what --set calls it
    double start;  ///< where R brings it back: the lesson's own start, or what --set said
    double min, max;  ///< its range, both ends included; min < max
    lighting::Text label;  ///< what it means, with its unit
    double value;  ///< now; from min to max
    double own = start;  ///< the lesson's own start, whatever --set says

    /// About 1/100 of the range, rounded to 1, 2 or 5 times a power of ten.
    double step() const;
};

/// A number that a lesson reads off its scene.
struct Reading {
    lighting::Text label;
    double value;
};

/// The sliders of a program and the readings of its present frame.
class Controls {
  public:
    /// A new slider; the reference stays good as long as this object lives. Throws std::invalid_argument for a name that
    /// is empty, taken or holds '=', and for numbers that are not finite or not in order min <= start <= max, min < max.
    const double& add(const std::string& name, double start, double min, double max, lighting::Text label);
    /// Puts sliders where --set wants them ("alpha=60"), as their new start. Returns what is wrong, or an empty text.
    std::string set(std::span<const std::string> assignments);
    /// Every slider back to where the lesson starts it, as if --set had said nothing.
    void forgetSet();
    /// Every slider back to its start.
    void reset();

    std::deque<Slider>& sliders() { return sliders_; }
    const std::deque<Slider>& sliders() const { return sliders_; }
    /// "alpha=60 k=0.5": what --set would need for this picture; empty without sliders.
    std::string text() const;

    std::vector<Reading> readings;  ///< of this frame, in the order in which they were shown

  private:
    std::deque<Slider> sliders_;  // a deque, so that references stay
};

/// A whole number as such, anything else with four significant digits.
std::string valueText(double value);

}  // namespace lab
