// Unit tests of ObjectLoader: malformed and unsupported scenes, each refused with file, path, expected and found.
// SPDX-License-Identifier: MIT
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace {

// The refusal's text, or "" where the text loads. Any other exception fails the test by itself.
std::string refusal(const std::string& json) {
    try {
        THREE::ObjectLoader().parse(json, "scena.json");
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

std::string refusalOfFile(const std::string& file) {
    try {
        THREE::ObjectLoader().load(file);
    } catch (const THREE::SceneError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::string position = R"("position":{"itemSize":3,"type":"Float32Array","array":[0,0,0,1,0,0,0,1,0]})";
const std::string triangle =
    R"({"uuid":"g","type":"BufferGeometry","data":{"attributes":{)" + position + "}}}";
const std::string lambert = R"({"uuid":"m","type":"MeshLambertMaterial","color":16746581})";
const std::string mesh = R"({"type":"Mesh","geometry":"g","material":"m"})";

std::string scene(const std::string& children, const std::string& geometries = triangle,
                  const std::string& materials = lambert, const std::string& more = "") {
    return R"({"geometries":[)" + geometries + R"(],"materials":[)" + materials +
           R"(],"object":{"type":"Scene")" + more + R"(,"children":[)" + children + "]}}";
}
std::string attribute(const std::string& fields) {
    return scene(mesh, R"({"uuid":"g","type":"BufferGeometry","data":{"attributes":{"position":{)" + fields +
                           "}}}}");
}
std::string data(const std::string& fields) {
    return scene(mesh, R"({"uuid":"g","type":"BufferGeometry","data":{"attributes":{)" + position + "}," +
                           fields + "}}");
}
std::string geometry(const std::string& fields) { return scene(mesh, R"({"uuid":"g",)" + fields + "}"); }
std::string material(const std::string& fields) {
    return scene(mesh, triangle, R"({"uuid":"m","type":"MeshLambertMaterial",)" + fields + "}");
}
std::string repeated(const std::string& part, int count) {
    std::string all;
    for (int i = 0; i < count; ++i)
        all += part;
    return all;
}
std::string nested(int levels) {
    return R"({"object":)" + repeated(R"({"type":"Group","children":[)", levels - 1) + R"({"type":"Group"})" +
           repeated("]}", levels - 1) + "}";
}

struct Case {
    std::string json;
    const char* message;  // after "scena.json: "
};

void expectAll(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
        const std::string found = refusal(c.json);
        EXPECT_TRUE(contains(found, std::string("scena.json: ") + c.message))
            << "expected " << c.message << "\nfound    " << found << "\nin       " << c.json.substr(0, 300);
    }
}

TEST(ObjectLoaderRefusals, saySyntaxWithLineAndColumn) {
    ASSERT_EQ(refusal(scene(mesh)), "") << "what the cases below spoil is good";
    expectAll({
        {"", "expected a scene, found an empty file"},
        {" \n ", "expected a scene, found an empty file"},
        {"{", "line 1, column 2: expected JSON"},
        {"{\n  \"object\": {\n    \"type\": \"Scene\",,\n", "line 3, column 21: expected JSON"},
        {scene(mesh).substr(0, 120), "line 1, column 121: expected JSON"},
        {"{\"object\":NaN}", "line 1, column 11: expected JSON"},
        {"{\"object\":\n1e999}", "line 2, column 5: expected JSON, found number overflow parsing '1e999'"},
        {"{\"a\":\"\xff\"}", "line 1, column 7: expected JSON"},
        {"{\"a\":\"\xc3", "line 1, column"},
        {scene(mesh) + "x", "line 1, column"},
        {std::string("{}\0{", 4), "line 1, column 3: expected JSON text, found a NUL byte"},
        {"\x7f"
         "ELF",
         "line 1, column 1: expected JSON"},
        {repeated("[", 1001), "line 1, column 1001: expected brackets at most 1000 deep"},
        {repeated("[", 300'000), "line 1, column 1001: expected brackets"},
        {R"({"object":{"type":"Scene","children":[{},{"type":"Mesh","type":"Group"}]}})",
         "object.children[1].type: expected each key once"},
    });
    EXPECT_EQ(refusal("\xef\xbb\xbf" + scene(mesh)), "") << "a byte order mark is no error";
}

TEST(ObjectLoaderRefusals, sayWhatKindOfFileItIs) {
    expectAll({
        {"[]", "expected three.js's JSON"},
        {"3", "expected three.js's JSON"},
        {"{}", "object: expected the scene's objects, found nothing"},
        {R"({"asset":{"version":"2.0"}})", "expected three.js's JSON, found glTF"},
        {R"({"project":{},"scene":{}})", "expected a scene, found a project of the three.js editor"},
        {R"({"metadata":{"version":3.1},"object":{}})",
         "metadata.version: expected format 4, found the number 3.1"},
        {R"({"metadata":{"type":"BufferGeometry"},"object":{}})", "metadata.type: expected \"Object\""},
        {R"({"metadata":7,"object":{}})", "metadata: expected an object, found the number 7"},
        {R"({"object":[]})", "object: expected an object, found an array of 0"},
        {R"({"object":{}})", "object.type: expected the name of an object's class"},
        {R"({"object":{"type":"Scene","children":3}})",
         "object.children: expected an array, found the number 3"},
        {R"({"object":{"type":"Scene","children":[3]}})",
         "object.children[0]: expected an object, found the number 3"},
        {nested(257), "object.children[0]"},
    });
    EXPECT_EQ(refusal(nested(256)), "");
    EXPECT_TRUE(contains(refusal(nested(257)), "expected at most 256 levels of objects"));
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithGeometries) {
    expectAll({
        {scene(mesh, "5"), "geometries[0]: expected an object, found the number 5"},
        {scene(mesh, R"({"type":"BoxGeometry"})"), "geometries[0].uuid: expected a text"},
        {scene(mesh, triangle + "," + triangle), "geometries[1].uuid: expected a uuid of its own"},
        {geometry(R"("type":"TubeGeometry")"), "geometries[0].type: TubeGeometry is not supported"},
        {geometry(R"("type":7)"), "geometries[0].type: expected a text, found the number 7"},
        {geometry(R"("type":"BufferGeometry")"), "geometries[0].data: expected an object"},
        {geometry(R"("type":"SphereGeometry","radius":"1")"),
         "geometries[0].radius: expected a number, found \"1\""},
        {geometry(R"("type":"SphereGeometry","radius":null)"),
         "geometries[0].radius: expected a number, found null"},
        {geometry(R"("type":"SphereGeometry","widthSegments":1e9)"), "geometries[0]: "},
        {geometry(R"("type":"CylinderGeometry","openEnded":1)"),
         "geometries[0].openEnded: expected true or false"},
    });
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithAttributes) {
    expectAll({
        {attribute(R"("itemSize":0,"type":"Float32Array","array":[])"),
         "geometries[0].data.attributes.position.itemSize: expected a whole number from 1 to 16, found the "
         "number 0"},
        {attribute(R"("itemSize":-1,"type":"Float32Array","array":[])"),
         "geometries[0].data.attributes.position.itemSize"},
        {attribute(R"("itemSize":1e9,"type":"Float32Array","array":[])"),
         "geometries[0].data.attributes.position.itemSize"},
        {attribute(R"("itemSize":2.5,"type":"Float32Array","array":[])"),
         "geometries[0].data.attributes.position.itemSize"},
        {attribute(R"("itemSize":2,"type":"Float32Array","array":[1,2])"),
         "geometries[0].data.attributes.position.itemSize: expected 3 numbers per vertex"},
        {attribute(R"("itemSize":3,"type":"Float32Array","array":[1,2,3,4])"),
         "geometries[0].data.attributes.position.array: expected a multiple of 3 (itemSize) numbers, found "
         "an array of 4"},
        {attribute(R"("itemSize":3,"type":"Float32Array","array":[1,2,null])"),
         "geometries[0].data.attributes.position.array[2]: expected a number of at most 1e36, found null"},
        {attribute(R"("itemSize":3,"type":"Float32Array","array":[1,2,1e37])"),
         "geometries[0].data.attributes.position.array[2]: expected a number of at most 1e36"},
        {attribute(R"("itemSize":3,"type":"Int8Array","array":[1,2,128])"),
         "geometries[0].data.attributes.position.array[2]: expected a whole number that fits Int8Array"},
        {attribute(R"("itemSize":3,"type":"Uint8Array","array":[1,2,0.5])"),
         "geometries[0].data.attributes.position.array[2]"},
        {attribute(R"("itemSize":3,"type":"Float99Array","array":[])"),
         "geometries[0].data.attributes.position.type: expected Float32Array"},
        {attribute(R"("isInterleavedBufferAttribute":true)"),
         "geometries[0].data.attributes.position: interleaved attributes are not supported"},
        {attribute(R"("itemSize":3,"type":"Float32Array","array":{})"),
         "geometries[0].data.attributes.position.array: expected an array, found an object"},
        {geometry(R"("type":"BufferGeometry","data":{"attributes":{)" + position +
                  R"(,"normal":{"itemSize":3,"type":"Float32Array","array":[0,0,1]}}})"),
         "geometries[0].data.attributes.normal: expected as many vertices as position has, 3, found 1"},
    });
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithIndices) {
    expectAll({
        {data(R"("index":{"type":"Uint16Array","array":[0,1,3]})"),
         "geometries[0].data.index.array[2]: expected the number of a vertex, below 3, found the number 3"},
        {data(R"("index":{"type":"Uint16Array","array":[0,1,-1]})"), "geometries[0].data.index.array[2]"},
        {data(R"("index":{"type":"Float32Array","array":[0,1,1.5]})"), "geometries[0].data.index.array[2]"},
        {data(R"("index":{"type":"Uint32Array","array":[0,1,4294967296]})"),
         "geometries[0].data.index.array[2]"},
        {data(R"("index":{"type":"Uint16Array","array":[0,1]})"),
         "geometries[0].data.index.array: expected 3 indices"},
        {data(R"("index":[0,1,2])"), "geometries[0].data.index: expected an object"},
        {data(R"("drawRange":{"start":0,"count":2})"), "geometries[0].data.drawRange: drawing a part"},
    });
    EXPECT_EQ(refusal(data(R"("drawRange":{"start":0,"count":null})")), "");
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithMaterials) {
    expectAll({
        {scene(mesh, triangle, R"({"type":"MeshLambertMaterial"})"), "materials[0].uuid: expected a text"},
        {scene(mesh, triangle, lambert + "," + lambert), "materials[1].uuid: expected a uuid of its own"},
        {scene(mesh, triangle, R"({"uuid":"m","type":"MeshStandardMaterial"})"),
         "materials[0].type: MeshStandardMaterial is not supported; use MeshLambertMaterial"},
        {scene(mesh, triangle, R"({"uuid":"m","type":"MeshPhysicalMaterial"})"),
         "materials[0].type: MeshPhysicalMaterial"},
        {material(R"("color":16777216)"), "materials[0].color: expected a whole number from 0 to 16777215"},
        {material(R"("color":-1)"), "materials[0].color: expected a whole number"},
        {material(R"("color":"red")"),
         "materials[0].color: expected a colour as the number 0xRRGGBB in decimal, found \"red\""},
        {material(R"("side":3)"), "materials[0].side: expected a whole number from 0 to 2"},
        {material(R"("visible":1)"), "materials[0].visible: expected true or false, found the number 1"},
        {material(R"("map":"t")"), "materials[0].map: textures are not supported"},
        {material(R"("emissiveMap":"t")"), "materials[0].emissiveMap: textures are not supported"},
        {material(R"("transparent":true,"opacity":0.5)"), "materials[0].opacity: transparent surfaces"},
        {material(R"("blending":2)"),
         "materials[0].blending: only normal blending (1) is supported, found the number 2"},
        {material(R"("alphaTest":2)"), "materials[0].alphaTest: "},
        {material(R"("depthTest":false)"), "materials[0].depthTest: expected true, found false"},
        {material(R"("depthWrite":false)"), "materials[0].depthWrite: "},
        {material(R"("colorWrite":false)"), "materials[0].colorWrite: "},
        {material(R"("wireframe":true)"), "materials[0].wireframe: "},
        {material(R"("vertexColors":true)"), "materials[0].vertexColors: "},
        {material(R"("vertexColors":2)"), "materials[0].vertexColors: "},
        {material(R"("depthFunc":7)"), "materials[0].depthFunc: "},
        {material(R"("stencilWrite":true,"stencilFunc":514)"), "materials[0].stencilFunc: "},
        {material(R"("polygonOffset":true,"polygonOffsetFactor":1)"), "materials[0].polygonOffset: "},
        {material(R"("emissiveIntensity":[])"), "materials[0].emissiveIntensity: expected a number"},
        {material(R"("color":255,"lambertColor":[1,2])"),
         "materials[0].lambertColor: expected an array of 3 numbers"},
    });
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithObjects) {
    expectAll({
        {scene(R"({"type":"Mesh","material":"m"})"),
         "object.children[0].geometry: expected the uuid of a geometry, found nothing"},
        {scene(R"({"type":"Mesh","geometry":"g"})"),
         "object.children[0].material: expected the uuid of a material, found nothing"},
        {scene(mesh + R"(,{"type":"Mesh","geometry":"m","material":"m"})"),
         "object.children[1].geometry: expected the uuid of one of the file's geometries, found \"m\""},
        {scene(R"({"type":"Mesh","geometry":"g","material":"no"})"),
         "object.children[0].material: expected the uuid"},
        {scene(R"({"type":"Mesh","geometry":"g","material":7})"),
         "object.children[0].material: expected a text"},
        {scene(R"({"type":"Mesh","geometry":"g","material":["m","m"]})"),
         "object.children[0].material: several materials"},
        {scene(R"({"type":"Mesh","geometry":"g","material":[]})"),
         "object.children[0].material: several materials"},
        {scene(R"({"type":"Mesh","geometry":"g","material":"m","morphTargetInfluences":[0,1]})"),
         "object.children[0].morphTargetInfluences[1]: morph targets"},
    });
}

TEST(ObjectLoaderRefusals, sayWhichClassesAreNotSupported) {
    expectAll({
        {scene(R"({"type":"SpotLight"})"), "object.children[0]: SpotLight is not supported"},
        {scene(R"({"type":"HemisphereLight","color":0})"),
         "object.children[0]: HemisphereLight is not supported"},
        {scene(R"({"type":"Line","geometry":"g"})"), "object.children[0]: Line is not supported"},
        {scene(R"({"type":"Points","geometry":"g"})"), "object.children[0]: Points is not supported"},
        {scene(R"({"type":"Sprite"})"), "object.children[0]: Sprite is not supported"},
        {scene(R"({"type":"SkinnedMesh"})"), "object.children[0]: SkinnedMesh is not supported"},
        {scene(R"({"type":"InstancedMesh","count":2})"),
         "object.children[0]: InstancedMesh is not supported"},
        {scene(R"({"type":"mesh"})"), "object.children[0]: mesh is not supported"},
    });
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithCamerasLightsAndPlaces) {
    const std::string light = R"({"type":"DirectionalLight","target":)";
    expectAll({
        {scene(R"({"type":"OrthographicCamera"})"), "object: the only camera, object.children[0]"},
        {scene(R"({"type":"PerspectiveCamera","filmOffset":1})"),
         "object.children[0].filmOffset: expected 0"},
        {scene(R"({"type":"PerspectiveCamera","visible":false,"view":{"enabled":true}})"),
         "object.children[0].view: "},
        {scene(R"({"type":"PerspectiveCamera","fov":"wide"})"),
         "object.children[0].fov: expected a number, found \"wide\""},
        {scene(R"({"type":"PointLight","intensity":1e300})"),
         "object.children[0].intensity: expected a number of at most 1e36"},
        {scene(R"({"type":"PointLight","color":"white"})"), "object.children[0].color: expected a colour"},
        {scene(R"({"type":"Group","matrix":[1]})"),
         "object.children[0].matrix: expected an array of 16 numbers, found an array of 1"},
        {scene(R"({"type":"Group","matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})"),
         "object.children[0].matrix: expected an affine matrix"},
        {scene(R"({"type":"Group","matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,null,1]})"),
         "object.children[0].matrix[14]: expected a number"},
        {scene(R"({"type":"Group","position":[1,2]})"),
         "object.children[0].position: expected an array of 3 numbers"},
        {scene(R"({"type":"Group","rotation":[1,2,3,"ABC"]})"),
         "object.children[0].rotation[3]: expected XYZ"},
        {scene(R"({"type":"Group","visible":"yes"})"), "object.children[0].visible: expected true or false"},
        {scene(R"({"type":"Group","name":7})"), "object.children[0].name: expected a text"},
        {scene(R"({"type":"Mesh","layers":1.5})"), "object.children[0].layers: expected a whole number"},
        {scene(light + "7}"), "object.children[0].target: expected a text"},
        {scene(light + R"("t"},{"type":"Group","uuid":"t"},{"type":"Group","uuid":"t"})"),
         "object.children[0].target: expected the uuid of one object, found \"t\"; 2 objects have it"},
    });
}

TEST(ObjectLoaderRefusals, sayWhatIsWrongWithTheScene) {
    expectAll({
        {scene(mesh, triangle, lambert, R"(,"fog":{"type":"Fog"})"), "object.fog: fog is not supported"},
        {scene(mesh, triangle, lambert, R"(,"background":"t")"),
         "object.background: expected a colour, found \"t\""},
    });
}

class ObjectLoaderFiles : public testing::Test {
  protected:
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("lambert_loader_" + std::to_string(::getpid()));
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return (folder / name).string();
    }
};

TEST_F(ObjectLoaderFiles, areRefusedByName) {
    const std::string missing = (folder / "manca.json").string();
    EXPECT_EQ(refusalOfFile(missing),
              missing +
                  ": expected a scene file, found no such file; check the name and the folder you are in");
    EXPECT_TRUE(contains(refusalOfFile(folder.string()), "found a folder"));
    EXPECT_TRUE(contains(refusalOfFile(write("vuoto.json", "")), "found an empty file"));
    EXPECT_TRUE(contains(refusalOfFile(write("binario.json", std::string("\x00\x01\x02", 3))), "NUL byte"));
    EXPECT_TRUE(contains(refusalOfFile("/dev/zero"), "found a device"));
    const std::string huge = write("enorme.json", "{");
    std::filesystem::resize_file(huge, (std::uintmax_t{1} << 30) + 1);  // sparse: takes no space
    EXPECT_TRUE(contains(refusalOfFile(huge), "expected a scene of at most 1 GiB, found 1073741825 bytes"));
    EXPECT_EQ(refusalOfFile(write("buono.json", scene(mesh))), "");
}

}  // namespace
