// Unit tests of the scene graph: who owns whom, in every order of destruction, and where things are in the world.
// SPDX-License-Identifier: MIT
#include "three/lights.hpp"
#include "three/object3d.hpp"
#include "three/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using THREE::Object3D;
using THREE::Vector3;

// An object whose end is noticed.
class Counted : public Object3D {
  public:
    explicit Counted(int& deaths) : deaths_(deaths) {}
    ~Counted() override { ++deaths_; }

  private:
    int& deaths_;
};

using Children = std::vector<Object3D*>;

// --- ownership and detaching

TEST(Ownership, AddedObjectsStayTheCallersAndKnowTheirParent) {
    Object3D parent, a, b, c;
    EXPECT_EQ(&parent.add(a, b, c), &parent);
    EXPECT_EQ(parent.children(), (Children{&a, &b, &c}));
    EXPECT_EQ(b.parent(), &parent);
    EXPECT_EQ(parent.parent(), nullptr);
}

TEST(Ownership, ADestroyedChildDetachesItself) {
    Object3D parent, first, last;
    {
        Object3D between;
        parent.add(first, between, last);
    }
    EXPECT_EQ(parent.children(), (Children{&first, &last}));
}

// A chain of three, destroyed in all six orders: whoever remains must not point at whoever is gone.
TEST(Ownership, AChainMayBeDestroyedInEveryOrder) {
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        SCOPED_TRACE(testing::Message() << order[0] << order[1] << order[2]);
        std::array<std::unique_ptr<Object3D>, 3> chain;
        for (auto& object : chain)
            object = std::make_unique<Object3D>();
        chain[0]->add(*chain[1]);
        chain[1]->add(*chain[2]);
        for (const std::size_t gone : order) {
            chain[gone].reset();
            for (std::size_t i = 0; i < 3; ++i) {
                if (chain[i] == nullptr)
                    continue;
                const bool hasParent = i > 0 && chain[i - 1] != nullptr;
                const bool hasChild = i < 2 && chain[i + 1] != nullptr;
                EXPECT_EQ(chain[i]->parent(), hasParent ? chain[i - 1].get() : nullptr);
                EXPECT_EQ(chain[i]->children(), hasChild ? Children{chain[i + 1].get()} : Children{});
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Ownership, AnOwnedChildDiesOnceWithItsOwner) {
    int deaths = 0;
    {
        Object3D parent;
        Counted& child = parent.add(std::make_unique<Counted>(deaths));
        Counted& grandchild = child.add(std::make_unique<Counted>(deaths));
        EXPECT_EQ(child.parent(), &parent);
        EXPECT_EQ(grandchild.parent(), &child);
        EXPECT_EQ(deaths, 0);
    }
    EXPECT_EQ(deaths, 2);
}

TEST(Ownership, AnUnownedObjectBelowAnOwnedOneSurvives) {
    Object3D survivor;
    {
        Object3D parent;
        parent.add(std::make_unique<Object3D>()).add(survivor);
        EXPECT_NE(survivor.parent(), nullptr);
    }
    EXPECT_EQ(survivor.parent(), nullptr);
}

TEST(Ownership, TravelsWithTheChildToAnotherParent) {
    int deaths = 0;
    auto from = std::make_unique<Object3D>();
    auto to = std::make_unique<Object3D>();
    Counted& child = from->add(std::make_unique<Counted>(deaths));
    to->add(child);
    EXPECT_EQ(child.parent(), to.get());
    EXPECT_TRUE(from->children().empty());
    from.reset();
    EXPECT_EQ(deaths, 0);
    to.reset();
    EXPECT_EQ(deaths, 1);
}

TEST(Ownership, TheNewParentMayGoFirstToo) {
    int deaths = 0;
    Object3D from;
    {
        Object3D to;
        to.add(from.add(std::make_unique<Counted>(deaths)));
    }
    EXPECT_EQ(deaths, 1);
    EXPECT_TRUE(from.children().empty());
}

TEST(Ownership, AnUnownedChildIsOwnedByNobodyAfterMovingEither) {
    int deaths = 0;
    {
        Counted child(deaths);
        Object3D from;
        {
            Object3D to;
            from.add(child);
            to.add(child);
            EXPECT_EQ(child.parent(), &to);
        }
        EXPECT_EQ(child.parent(), nullptr);
        EXPECT_EQ(deaths, 0);
    }
    EXPECT_EQ(deaths, 1);
}

TEST(Ownership, AddingAgainMovesToTheEndAndKeepsTheOwner) {
    int deaths = 0;
    {
        Object3D parent, other;
        Counted& owned = parent.add(std::make_unique<Counted>(deaths));
        parent.add(other);
        parent.add(owned);
        EXPECT_EQ(parent.children(), (Children{&other, &owned}));
        EXPECT_EQ(deaths, 0);
    }
    EXPECT_EQ(deaths, 1);
}

// What the caller held while it already hung somewhere.
TEST(Ownership, AdoptingTakesTheObjectFromWhereItHung) {
    int deaths = 0;
    Object3D before;
    auto child = std::make_unique<Counted>(deaths);
    before.add(*child);
    {
        Object3D after;
        after.add(std::move(child));
        EXPECT_TRUE(before.children().empty());
    }
    EXPECT_EQ(deaths, 1);
}

TEST(Ownership, RemoveDestroysWhatItOwnsAndOnlyThat) {
    int deaths = 0;
    Object3D parent;
    Counted mine(deaths);
    Counted& owned = parent.add(std::make_unique<Counted>(deaths));
    parent.add(mine);
    EXPECT_EQ(&parent.remove(mine), &parent);
    EXPECT_EQ(mine.parent(), nullptr);
    EXPECT_EQ(deaths, 0);
    EXPECT_EQ(parent.children(), Children{&owned});
    parent.remove(owned);
    EXPECT_EQ(deaths, 1);
    EXPECT_TRUE(parent.children().empty());
}

TEST(Ownership, RemoveOfSomebodyElsesChildDoesNothing) {
    int deaths = 0;
    Object3D parent, stranger, loose;
    Counted& owned = parent.add(std::make_unique<Counted>(deaths));
    stranger.remove(owned);
    stranger.remove(loose);
    parent.remove(parent);
    EXPECT_EQ(deaths, 0);
    EXPECT_EQ(owned.parent(), &parent);
    EXPECT_EQ(parent.children(), Children{&owned});
}

TEST(Ownership, CyclesAreRefusedByNameAndChangeNothing) {
    Object3D top, middle, bottom;
    top.name = "cima";
    top.add(middle);
    middle.add(bottom);
    for (Object3D* below : {&top, &middle, &bottom})
        try {
            below->add(top);
            ADD_FAILURE() << "a cycle was accepted";
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find("'cima'"), std::string::npos) << error.what();
        }
    EXPECT_EQ(top.children(), Children{&middle});
    EXPECT_EQ(middle.children(), Children{&bottom});
    EXPECT_TRUE(bottom.children().empty());
    EXPECT_EQ(top.parent(), nullptr);
}

TEST(Ownership, ALightMayHoldItsOwnTarget) {
    Object3D scene;
    {
        THREE::DirectionalLight light;
        light.add(light.target);
        scene.add(light);
        EXPECT_EQ(light.target.parent(), &light);
    }
    EXPECT_TRUE(scene.children().empty());
    {
        THREE::DirectionalLight light;
        scene.add(light.target);
    }
    EXPECT_TRUE(scene.children().empty());
}

// --- traversal

struct Tree : testing::Test {
    Object3D root, a, a1, a2, b;
    Tree() {
        root.name = "root", a.name = "a", a1.name = "a1", a2.name = "a2", b.name = "b";
        root.add(a, b);
        a.add(a1, a2);
    }
};

TEST_F(Tree, TraverseVisitsParentsFirstAndSiblingsInOrder) {
    std::string visited;
    root.traverse([&visited](Object3D& object) { visited += object.name + " "; });
    EXPECT_EQ(visited, "root a a1 a2 b ");
    visited.clear();
    const Object3D& constant = a;
    constant.traverse([&visited](const Object3D& object) { visited += object.name + " "; });
    EXPECT_EQ(visited, "a a1 a2 ");
}

TEST_F(Tree, InvisibleObjectsHideWhatHangsBelowThem) {
    const auto visible = [this] {
        std::string visited;
        root.traverseVisible([&visited](const Object3D& object) { visited += object.name + " "; });
        return visited;
    };
    EXPECT_EQ(visible(), "root a a1 a2 b ");
    a1.visible = false;
    EXPECT_EQ(visible(), "root a a2 b ");
    a.visible = false;
    EXPECT_EQ(visible(), "root b ");
    root.visible = false;
    EXPECT_EQ(visible(), "");
}

TEST_F(Tree, GetObjectByNameFindsTheFirst) {
    b.name = "a2";
    EXPECT_EQ(root.getObjectByName("root"), &root);
    EXPECT_EQ(root.getObjectByName("a2"), &a2);
    EXPECT_EQ(root.getObjectByName("nobody"), nullptr);
    EXPECT_EQ(a.getObjectByName("root"), nullptr);
}

// --- rotation and quaternion say the same

void expectTurn(const Object3D& object, double x, double y, double z, double w) {
    EXPECT_NEAR(object.quaternion.x, x, 1e-15);
    EXPECT_NEAR(object.quaternion.y, y, 1e-15);
    EXPECT_NEAR(object.quaternion.z, z, 1e-15);
    EXPECT_NEAR(object.quaternion.w, w, 1e-15);
}

TEST(Turning, TheQuaternionFollowsTheRotation) {
    Object3D mesh;
    mesh.rotation.x += 0.1;
    expectTurn(mesh, std::sin(0.05), 0, 0, std::cos(0.05));
    mesh.rotation.x += 0.1;
    expectTurn(mesh, std::sin(0.1), 0, 0, std::cos(0.1));
    mesh.rotation.set(0, 0, std::numbers::pi / 3);
    expectTurn(mesh, 0, 0, 0.5, std::sqrt(0.75));
    mesh.rotation = THREE::Euler(0, std::numbers::pi, 0);
    expectTurn(mesh, 0, 1, 0, 0);
}

TEST(Turning, TheRotationFollowsTheQuaternion) {
    Object3D mesh;
    mesh.quaternion.set(0, std::sin(0.35), 0, std::cos(0.35));
    EXPECT_NEAR(mesh.rotation.y, 0.7, 1e-15);
    EXPECT_NEAR(mesh.rotation.x, 0, 1e-15);
    mesh.quaternion.setFromAxisAngle({1, 0, 0}, -0.4);
    EXPECT_NEAR(mesh.rotation.x, -0.4, 1e-15);
    EXPECT_NEAR(mesh.rotation.y, 0, 1e-15);
    mesh.rotation.x += 0.1;  // goes on from what the quaternion said
    expectTurn(mesh, std::sin(-0.15), 0, 0, std::cos(-0.15));
}

// While components are written one by one the quaternion has no unit length; what it points at counts.
TEST(Turning, AQuaternionOfAnyLengthMeansTheSameAngles) {
    Object3D mesh;
    mesh.quaternion.z = 1;  // now (0,0,1,1): a quarter turn
    EXPECT_NEAR(mesh.rotation.z, std::numbers::pi / 2, 1e-15);
    EXPECT_EQ(mesh.quaternion.w, 1);  // and is not rewritten behind the caller's back
}

TEST(Turning, TheOrderOfTheAnglesStays) {
    Object3D mesh;
    mesh.rotation.set(0.1, 0.2, 0.3, THREE::EulerOrder::ZYX);
    const THREE::Quaternion turned(glm::dquat(mesh.quaternion));
    mesh.quaternion = THREE::Quaternion();
    mesh.quaternion = turned;
    EXPECT_EQ(mesh.rotation.order(), THREE::EulerOrder::ZYX);
    EXPECT_NEAR(mesh.rotation.x, 0.1, 1e-15);
    EXPECT_NEAR(mesh.rotation.y, 0.2, 1e-15);
    EXPECT_NEAR(mesh.rotation.z, 0.3, 1e-15);
}

}  // namespace
