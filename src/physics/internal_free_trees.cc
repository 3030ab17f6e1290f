#include "physics/internal_free_trees.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>

namespace smile::physics {
namespace {

mechanics::TreeLink LinkOf(const btMultibodyLink& link) {
  const bool is_revolute = link.m_jointType == btMultibodyLink::eRevolute;
  return {.parent = link.m_parent,
          .R_LP = FromBullet(btMatrix3x3(link.m_cachedRotParentToThis)),
          .p_PL = FromBullet(link.m_cachedRVector),
          .p_JL = FromBullet(link.m_dVector),
          .axis = FromBullet(is_revolute ? link.getAxisTop(0) : link.getAxisBottom(0)),
          .is_revolute = is_revolute,
          .mass = link.m_mass,
          .inertia = FromBullet(link.m_inertiaLocal)};
}

const btMultiBody* TreeOf(const btCollisionObject* object) {
  const btMultiBodyLinkCollider* link = btMultiBodyLinkCollider::upcast(object);
  return link == nullptr ? nullptr : link->m_multiBody;
}

template <class T, class Predicate>
void EraseIf(btAlignedObjectArray<T>* array, Predicate predicate) {
  const auto all = All(*array);
  array->resize(static_cast<int>(std::remove_if(all.begin(), all.end(), predicate) - all.begin()));
}

}  // namespace

void FreeTrees::Solve(std::span<btPersistentManifold* const> manifolds, double seconds,
                      btAlignedObjectArray<btMultiBody*>* trees,
                      btAlignedObjectArray<btMultiBodyConstraint*>* constraints) {
  trees_.resize(trees->size());
  for (int i = 0; i < trees->size(); ++i) {
    trees_[i].multibody = trees->at(i);
    trees_[i].is_free = true;
    trees_[i].drives.clear();
  }
  for (const btPersistentManifold* manifold : manifolds) {
    if (manifold->getNumContacts() == 0) continue;
    Touch(TreeOf(manifold->getBody0()));
    Touch(TreeOf(manifold->getBody1()));
  }
  for (btMultiBodyConstraint* constraint : All(*constraints)) {
    if (const auto* drive = dynamic_cast<const JointDrive*>(constraint)) {
      const auto tree = std::ranges::find(trees_, constraint->getMultiBodyA(), &Tree::multibody);
      tree->drives.push_back(drive);
    } else {
      Touch(constraint->getMultiBodyA());
      Touch(constraint->getMultiBodyB());
    }
  }
  for (Tree& tree : trees_) tree.is_free = tree.is_free && Move(seconds, &tree);
  EraseIf(trees, [this](const btMultiBody* tree) { return IsFree(tree); });
  EraseIf(constraints, [this](const btMultiBodyConstraint* constraint) {
    return IsFree(const_cast<btMultiBodyConstraint*>(constraint)->getMultiBodyA());
  });
}

void FreeTrees::Touch(const btMultiBody* multibody) {
  const auto tree = std::ranges::find(trees_, multibody, &Tree::multibody);
  if (tree != trees_.end()) tree->is_free = false;
}

bool FreeTrees::IsFree(const btMultiBody* multibody) const {
  const auto tree = std::ranges::find(trees_, multibody, &Tree::multibody);
  return tree != trees_.end() && tree->is_free;
}

/// Returns false, and changes nothing, if the motors cannot do what is wanted.
bool FreeTrees::Move(double seconds, Tree* tree) {
  btMultiBody& multibody = *tree->multibody;
  const int count = multibody.getNumLinks();
  if (count == 0) return false;
  tree->motion.links.resize(count);
  tree->motion.goals.resize(count);
  for (int i = 0; i < count; ++i) tree->motion.links[i] = LinkOf(multibody.getLink(i));
  // Each link has a drive.
  for (const JointDrive* drive : tree->drives) {
    tree->motion.goals[drive->link()] = drive->GoalFor(seconds);
  }
  if (!tree->motion.Solve(seconds)) return false;
  for (int i = 0; i < count; ++i) multibody.setJointVel(i, tree->motion.velocities()[i]);
  multibody.clearForcesAndTorques();
  return true;
}

}  // namespace smile::physics
