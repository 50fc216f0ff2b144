// Where an object of a scene file stands: matrix, or position, rotation and scale.
// SPDX-License-Identifier: MIT
#include "three/tree_loader.hpp"

#include <algorithm>
#include <cmath>

namespace THREE {

namespace {

Vector3 vector(const Node& node) {
    const std::vector<double> v = node.numbers(3);
    return {v[0], v[1], v[2]};
}

// three.js writes [x, y, z, "XYZ"]; the order may be missing.
Euler euler(const Node& node) {
    static const std::pair<const char*, EulerOrder> orders[] = {
        {"XYZ", EulerOrder::XYZ}, {"YXZ", EulerOrder::YXZ}, {"ZXY", EulerOrder::ZXY},
        {"ZYX", EulerOrder::ZYX}, {"YZX", EulerOrder::YZX}, {"XZY", EulerOrder::XZY}};
    const std::size_t size = node.array().size();
    if (size != 3 && size != 4)
        node.fail("three angles in radians and an order such as \"XYZ\"");
    const double x = node.at(std::size_t{0}).number();
    const double y = node.at(1).number();
    const double z = node.at(2).number();
    if (size == 3)
        return {x, y, z};
    const std::string name = node.at(3).text();
    for (const auto& [text, order] : orders)
        if (name == text)
            return {x, y, z, order};
    node.at(3).fail("XYZ, YXZ, ZXY, ZYX, YZX or XZY");
}

void loadParts(const Node& node, Object3D& object) {
    if (const auto field = node.find("position"))
        object.position = vector(*field);
    if (const auto field = node.find("rotation"))
        object.rotation = euler(*field);
    if (const auto field = node.find("quaternion")) {
        const std::vector<double> q = field->numbers(4);
        object.quaternion.set(q[0], q[1], q[2], q[3]);
    }
    if (const auto field = node.find("scale"))
        object.scale = vector(*field);
}

// Each number of the file is at most 1e36; what follows from several of them must be so too, or the scene could be
// written but not be read again.
void checkResult(const Node& node, const Object3D& object) {
    std::vector<double> results = {object.scale.x, object.scale.y, object.scale.z};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            results.push_back(object.matrix.elements[column][row]);
    for (const double result : results)
        if (!(std::abs(result) <= largestNumber))
            node.refuse(
                "expected a place whose matrix and scale are numbers of at most 1e36, found larger ones; "
                "scale the scene down");
}

bool sameMatrix(const Matrix4& a, const Matrix4& b) { return a.elements == b.elements; }

double largestDifference(const Matrix4& a, const Matrix4& b) {
    double largest = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            largest = std::max(largest, std::abs(a.elements[column][row] - b.elements[column][row]));
    return largest;
}

// The matrix counts, as in three.js. The parts that toJSON writes beside it are taken only while they still mean
// exactly that matrix: then they are the very doubles that the matrix came from.
std::string loadMatrix(const Node& node, Object3D& object, bool hasParts) {
    const std::vector<double> numbers = node.numbers(16);
    double columns[16];
    std::copy(numbers.begin(), numbers.end(), columns);
    if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1)
        node.refuse("expected an affine matrix, whose elements 3, 7, 11 and 15 are 0, 0, 0 and 1, found " +
                    node.value()[3].dump() + ", " + node.value()[7].dump() + ", " + node.value()[11].dump() +
                    " and " + node.value()[15].dump());
    const Matrix4 wanted = Matrix4().fromArray(columns);
    object.updateMatrix();
    const bool partsCount = hasParts && (!object.matrixAutoUpdate || sameMatrix(object.matrix, wanted));
    if (!partsCount)
        object.applyMatrix4(wanted);
    object.matrix = wanted;
    if (!object.matrixAutoUpdate)
        return "";
    object.updateMatrix();
    const double size = largestDifference(wanted, Matrix4(glm::dmat4(0.0)));
    if (largestDifference(object.matrix, wanted) <= 1e-6 * size)
        return "";
    return node.path() +
           ": its shear is left out, as three.js does; set matrixAutoUpdate to false to keep it";
}

}  // namespace

std::string loadPlace(const Node& node, Object3D& object) {
    object.name = node.text("name", "");
    object.visible = node.boolean("visible", true);
    object.matrixAutoUpdate = node.boolean("matrixAutoUpdate", true);
    if (const auto field = node.find("up"))
        object.up = vector(*field);
    const std::optional<Node> matrix = node.findSet("matrix");
    const bool hasParts =
        node.find("position") || node.find("rotation") || node.find("quaternion") || node.find("scale");
    loadParts(node, object);
    std::string lost;
    if (matrix)
        lost = loadMatrix(*matrix, object, hasParts);
    else
        object.updateMatrix();
    checkResult(node, object);
    return lost;
}

}  // namespace THREE
