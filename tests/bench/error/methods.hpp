// The ways to compute the lighting that the error benchmark compares.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/world.hpp"
#include "image/frame.hpp"

#include <memory>
#include <string>
#include <vector>

namespace bench::error {

/// What does the work.
enum class Kind {
    shaders,  ///< OpenGL ES, one pass
    passes,  ///< a pass for every light, added up in 8 bits
    processor  ///< lighting::reference in double, without GL
};

/// A row of the table.
struct Method {
    const char* id;  ///< for files; also its folder below methods/, if `overlay`
    const char* title;  ///< for charts; no comma or quote in it
    const char* known;  ///< what is known to be wrong with it
    Kind kind = Kind::shaders;
    bool overlay = false;  ///< methods/<id>/ holds shader files that stand in for the lab's own
    lighting::Shading shading = lighting::Shading::pixel;
    bool scaled = false;  ///< every draw in the form for extreme distances
    double cut = 0;  ///< lights that no mesh gets so much of are left out, 8-bit codes
    bool approximate = false;  ///< wrong by design: a difference from the default is what one expects
};

/// All methods; the first is the default, the second the one that costs are relative to.
const std::vector<Method>& methods();
inline constexpr std::size_t defaultMethod = 0, threeMethod = 1;

/// Whether a method of methods() does the very work of the default in this world: a cut that leaves nothing out.
bool isDefault(const Method& method, const World& world);

/// Draws one world again and again, in one way.
class Drawer {
  public:
    virtual ~Drawer() = default;
    /// A frame in floats or in 8 bits; when it returns, all work is done.
    virtual image::Frame draw(bool floats) = 0;
};

/// `world` must outlive it. Needs the context of support::renderer().
std::unique_ptr<Drawer> makeDrawer(const Method& method, World& world, int size);

}  // namespace bench::error
