// A rubric: what is looked at in a lesson's submissions, and what it is worth. Data beside the lesson (lesson_NN.rubric.json).
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/catalogue/texts.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader {

/// What is judged by the scene that a lesson's program makes.
struct StepCheck {
    std::string id;  ///< "36.3", of the lesson's NUOVO lines; "before" for all that the starter had
    std::vector<int> slides;
    double points = 0;
    bool isNew = true;
    BothLanguages title, expected;
    /// Of the scene, see scene_difference.hpp: "point[0].decay"; * and ? stand for anything. Each that is right earns its share of the points.
    std::vector<std::string> aspects;
    std::vector<std::string>
        keeps;  ///< aspects that the starter has right already: they earn nothing and cost as much
    std::vector<std::string> variants;  ///< ids of frames without which the check fails; empty: all
};

/// What is judged by the picture that a student's shader makes. Title and texts stand in the catalogue, by its name.
struct TermCheck {
    std::string id;  ///< a term of the lab's table, or sum, normals, colours
    double points = 0;
    bool isNew = false;
    std::map<std::string, double>
        credit;  ///< what is left, 0 to 1, where this misconception is the whole mistake
};

/// A frame that is asked of each view, by options of the lab's command line.
struct Variant {
    std::string id;
    std::vector<std::string> options;
    bool lamp = false;  ///< with one more directional light, so that materials show where the lesson has none
};

struct Rubric {
    std::string lesson;  ///< "lesson_05_attenuation"
    double points = 100;  ///< of a submission without a fault
    std::uint64_t seed = 0;  ///< of the hidden views
    std::vector<std::string>
        required;  ///< parts that must be handed in: "lesson", "terms/cosine.glsl"; others are the lab's
    int views = 3;  ///< hidden cameras, times and jitters
    int size = 160;  ///< of the square frames, pixels
    double seconds = 10;  ///< times are from 0 to this
    std::array<double, 3> lookAt{};  ///< what hidden cameras look at, world space
    std::array<double, 2> distance{6, 8};  ///< their distance from it, world units
    std::array<double, 2> azimuth{0, 360};  ///< around it, degrees; 0 is the side of +z, 90 that of +x
    std::array<double, 2> height{10, 50};  ///< above the horizon, degrees
    double fov = 36;  ///< vertical, degrees
    std::vector<Variant> variants;
    int scenes = 2;  ///< hidden scenes that shader terms are tried on
    bool shiny = false;  ///< with highlights
    std::vector<StepCheck> steps;
    std::vector<TermCheck> terms;
    std::string hash;  ///< SHA-256 of the file

    /// Reads a rubric. Throws std::runtime_error: file, field, expected and found.
    static Rubric read(const std::filesystem::path& file);
};

}  // namespace grader
