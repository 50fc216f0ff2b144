// Which exception means which status.
// SPDX-License-Identifier: MIT
#include "lab/failure.hpp"

#include "image/frame.hpp"
#include "render/error.hpp"
#include "three/validate.hpp"

#include <new>

namespace lab {

std::optional<Failure> attempt(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (const UsageError& error) {
        return Failure{wrongUsage, error.what()};
    } catch (const render::NoRenderer& error) {
        return Failure{noRenderer, error.what()};
    } catch (const render::ShaderError& error) {
        return Failure{noRenderer, error.what()};
    } catch (const THREE::SceneError& error) {
        return Failure{unusableScene, error.what()};
    } catch (const image::Error& error) {
        return Failure{cannotWrite, error.what()};
    } catch (const std::bad_alloc&) {
        return Failure{noRenderer, "not enough memory for this scene at this size; choose a smaller --size"};
    } catch (const std::exception& error) {
        return Failure{unusableScene, error.what()};
    }
}

}  // namespace lab
