// Geometries of a scene file: attributes, indices and what is refused about them.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"
#include "three/scene_file.hpp"
#include "three/scene_library.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace THREE {

namespace {

// JavaScript's typed arrays. `unit`: what an element is divided by where the attribute is "normalized", as OpenGL does.
struct ArrayType {
    const char* name;
    double lowest, highest, unit;
};

constexpr double anyNumber = std::numeric_limits<double>::max();
constexpr ArrayType arrayTypes[] = {
    {"Float32Array", -anyNumber, anyNumber, 0},
    {"Float64Array", -anyNumber, anyNumber, 0},
    {"Int8Array", -128, 127, 127},
    {"Uint8Array", 0, 255, 255},
    {"Uint8ClampedArray", 0, 255, 255},
    {"Int16Array", -32768, 32767, 32767},
    {"Uint16Array", 0, 65535, 65535},
    {"Int32Array", -2147483648.0, 2147483647, 2147483647},
    {"Uint32Array", 0, 4294967295, 4294967295},
};

const ArrayType& arrayType(const Node& node) {
    const Node name = node.at("type", "the name of a typed array such as \"Float32Array\"");
    const std::string wanted = name.text();
    for (const ArrayType& type : arrayTypes)
        if (wanted == type.name)
            return type;
    name.fail("Float32Array, Float64Array, or (U)int8Array, (U)int16Array, (U)int32Array");
}

std::vector<double> elements(const Node& node, const ArrayType& type, bool normalized) {
    const Node array = node.at("array", "an array of numbers");
    std::vector<double> all;
    all.reserve(array.array().size());
    for (std::size_t i = 0; i < array.size(); ++i) {
        const nlohmann::json& element = array.value()[i];
        double x = element.is_number() ? element.get<double>() : std::nan("");
        const bool isWhole = type.unit != 0;
        if (!(std::abs(x) <= largestNumber) || x < type.lowest || x > type.highest ||
            (isWhole && x != std::floor(x)))
            array.at(i).fail(isWhole ? "a whole number that fits " + std::string(type.name)
                                     : std::string("a number of at most 1e36"));
        if (normalized && isWhole)
            x = std::max(x / type.unit, -1.0);
        all.push_back(x);
    }
    return all;
}

BufferAttribute loadAttribute(const Node& node, const std::string& name) {
    if (node.boolean("isInterleavedBufferAttribute", false))
        node.unsupported(
            "interleaved attributes are not supported; write it as a BufferAttribute of its own");
    if (node.boolean("isInstancedBufferAttribute", false))
        node.unsupported("instanced attributes are not supported; write one mesh per instance");
    const Node itemSize = node.at("itemSize", "the numbers per vertex");
    BufferAttribute attribute;
    attribute.itemSize = static_cast<int>(itemSize.whole(1, 16));
    if ((name == "position" || name == "normal") && attribute.itemSize != 3)
        itemSize.fail("3 numbers per vertex");
    attribute.array = elements(node, arrayType(node), node.boolean("normalized", false));
    if (attribute.array.size() % static_cast<std::size_t>(attribute.itemSize) != 0)
        node.at("array", "an array")
            .fail("a multiple of " + std::to_string(attribute.itemSize) + " (itemSize) numbers");
    return attribute;
}

void loadAttributes(const Node& data, BufferGeometry& geometry) {
    const std::optional<Node> attributes = data.findSet("attributes");
    if (!attributes)
        return;
    for (const auto& field : attributes->object().value().items()) {
        const Node node = attributes->at(field.key(), "an attribute");
        BufferAttribute attribute = loadAttribute(node, field.key());
        geometry.setAttribute(field.key(), std::move(attribute.array), attribute.itemSize);
    }
    for (const auto& [name, attribute] : geometry.attributes)
        if (attribute.count() != geometry.vertexCount())
            attributes->at(name, "an attribute")
                .refuse("expected as many vertices as position has, " +
                        std::to_string(geometry.vertexCount()) + ", found " +
                        std::to_string(attribute.count()));
}

void loadIndex(const Node& data, BufferGeometry& geometry) {
    const std::optional<Node> index = data.findSet("index");
    if (!index)
        return;
    const Node array = index->at("array", "an array of vertex numbers");
    const ArrayType& type = arrayType(*index);
    const std::vector<double> numbers = elements(*index, type, false);
    std::vector<std::uint32_t> indices;
    indices.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double x = numbers[i];
        if (!(x == std::floor(x) && x >= 0 && x < static_cast<double>(geometry.vertexCount())))
            array.at(i).fail("the number of a vertex, below " + std::to_string(geometry.vertexCount()));
        indices.push_back(static_cast<std::uint32_t>(x));
    }
    // Lines and points have such indices, and are refused (or left out) for what they are.
    if (indices.size() % 3 != 0)
        array.unsupported("expected 3 indices per triangle, found " + std::to_string(indices.size()) +
                          " indices; only meshes of triangles are drawn");
    geometry.setIndex(std::move(indices));
}

double drawnCount(const BufferGeometry& geometry) {
    return static_cast<double>(geometry.index.empty() ? geometry.vertexCount() : geometry.index.size());
}

// JSON writes the usual count, Infinity, as null.
void checkDrawRange(const Node& node, const BufferGeometry& geometry) {
    const std::optional<Node> range = node.findSet("drawRange");
    if (!range)
        return;
    const double start = range->number("start", 0);
    const std::optional<Node> count = range->findSet("count");
    if (start != 0 || (count && count->number() < drawnCount(geometry)))
        range->unsupported("drawing a part of a geometry is not supported; cut the arrays instead");
}

}  // namespace

std::shared_ptr<BufferGeometry> loadGeometry(const Node& node, double& parametric) {
    const Node typeNode = node.at("type", "the name of a geometry such as \"BoxGeometry\"");
    const std::string type = typeNode.text();
    std::shared_ptr<BufferGeometry> geometry = loadParametric(node, type);
    if (geometry != nullptr) {
        parametric += static_cast<double>(geometry->vertexCount());
        if (parametric > maxParametricVertices)
            node.refuse("expected at most 5 million vertices in a file's parametric geometries, found more; "
                        "use fewer "
                        "segments");
    } else {
        if (type != "BufferGeometry")
            typeNode.unsupported(printable(type) +
                                 " is not supported; use BufferGeometry, Box-, Sphere-, Plane-, Torus-, "
                                 "TorusKnot-, Cylinder- or ConeGeometry");
        geometry = std::make_shared<BufferGeometry>();
        const Node data = node.at("data", "an object with attributes and index");
        loadAttributes(data.object(), *geometry);
        loadIndex(data, *geometry);
        checkDrawRange(data, *geometry);
        if (geometry->index.empty() && geometry->vertexCount() % 3 != 0)
            data.unsupported("expected 3 vertices per triangle where there is no index, found " +
                             std::to_string(geometry->vertexCount()) +
                             "; only meshes of triangles are drawn");
    }
    checkDrawRange(node, *geometry);
    geometry->name = node.text("name", "");
    return geometry;
}

std::string geometryNote(const Node& node) {
    const std::optional<Node> data = node.findSet("data");
    const std::optional<Node> morph = data ? data->findSet("morphAttributes") : std::nullopt;
    if (!morph || morph->object().size() == 0)
        return "";
    return morph->path() + ": morph targets are left out: at rest they do not show";
}

bool groupsCoverAll(const Node& node, const BufferGeometry& geometry) {
    const std::optional<Node> data = node.findSet("data");
    const std::optional<Node> groups = data ? data->findSet("groups") : std::nullopt;
    if (!groups)
        return false;
    double covered = 0;
    for (std::size_t i = 0; i < groups->array().size(); ++i) {
        const Node group = groups->at(i);
        const std::optional<Node> count = group.findSet("count");
        if (group.number("materialIndex", 0) != 0 || group.number("start", 0) != covered)
            return false;
        covered = count ? covered + count->number() : drawnCount(geometry);
    }
    return covered >= drawnCount(geometry);
}

}  // namespace THREE
