// Geometries, materials and colours as three.js's JSON.
// SPDX-License-Identifier: MIT
#include "three/resource_writer.hpp"

#include <algorithm>
#include <cstdio>

namespace THREE {

std::string uuid(Kind kind, std::uint64_t number) {
    char text[64];  // version 4, variant 8, as three.js's are
    std::snprintf(text, sizeof text, "%08x-0000-4000-8000-%012llx", static_cast<unsigned>(kind),
                  static_cast<unsigned long long>(number));
    return text;
}

void writeColor(JsonWriter& json, const char* key, const char* exactKey, const Color& color) {
    const std::vector<double> exact = {color.r, color.g, color.b};
    const bool isFinite = std::all_of(exact.begin(), exact.end(), [](double c) { return c - c == 0; });
    const std::uint32_t hex = isFinite ? color.getHex() : 0;
    json.field(key, static_cast<double>(hex));
    if (!(Color(hex) == color))  // NaN comes here too, and is refused by name
        json.field(exactKey, exact);
}

namespace {

void writeArrays(JsonWriter& json, const BufferGeometry& geometry) {
    json.key("data").beginObject().key("attributes").beginObject();
    for (const auto& [name, attribute] : geometry.attributes) {
        json.key(name).beginObject().field("itemSize", static_cast<double>(attribute.itemSize));
        // Float32Array is what three.js can draw; it rounds on reading, and our loader does not.
        json.field("type", "Float32Array").field("array", attribute.array).field("normalized", false);
        json.endObject();
    }
    json.endObject();
    if (!geometry.index.empty()) {
        const std::uint32_t last = *std::max_element(geometry.index.begin(), geometry.index.end());
        json.key("index").beginObject().field("type", last < 65535 ? "Uint16Array" : "Uint32Array");
        json.field("array", geometry.index).endObject();
    }
    json.endObject();
}

std::string whose(const char* type, const std::string& name) {
    return name.empty() ? type : std::string(type) + " '" + name + "'";
}

}  // namespace

void writeGeometry(JsonWriter& json, const BufferGeometry& geometry, const std::string& id) {
    json.whose = [&geometry] { return whose(geometry.type(), geometry.name); };
    const bool isUntouched = isAsConstructed(geometry);
    json.beginObject().field("uuid", id).field("type", isUntouched ? geometry.type() : "BufferGeometry");
    if (!geometry.name.empty())
        json.field("name", geometry.name);
    if (isUntouched) {
        for (const auto& [name, number] : geometry.parameters()) {
            if (name == "openEnded")
                json.field(name, number != 0);
            else
                json.field(name, number);
        }
    } else {
        writeArrays(json, geometry);
    }
    json.endObject();
}

void writeMaterial(JsonWriter& json, const Material& material, const std::string& id) {
    json.whose = [&material] { return whose(material.type(), material.name); };
    json.beginObject().field("uuid", id).field("type", material.type());
    if (!material.name.empty())
        json.field("name", material.name);
    writeColor(json, "color", "lambertColor", material.color);
    if (const auto* lambert = dynamic_cast<const MeshLambertMaterial*>(&material)) {
        writeColor(json, "emissive", "lambertEmissive", lambert->emissive);
        if (lambert->emissiveIntensity != 1)
            json.field("emissiveIntensity", lambert->emissiveIntensity);
    }
    if (const auto* phong = dynamic_cast<const MeshPhongMaterial*>(&material)) {
        writeColor(json, "specular", "lambertSpecular", phong->specular);
        json.field("shininess", phong->shininess);
        // three.js keeps userData and has one model only: what a file does not say is blinn.
        if (phong->specularModel == SpecularModel::phong)
            json.key("userData").beginObject().field("specularModel", "phong").endObject();
    }
    if (material.side != FrontSide)
        json.field("side", static_cast<double>(material.side));
    if (material.flatShading)
        json.field("flatShading", true);
    if (!material.visible)
        json.field("visible", false);
    json.endObject();
}

}  // namespace THREE
