#!/bin/sh
# ./cookbook take knows the words that a game programmer types, and what it lists first is what the pages
# tell to take: check_terms.sh ROOT WORK. A line each: word, header, what is listed first.
set -eu
root=$1 work=$2
mkdir -p "$work"

words() {
  cat <<'WORDS'
normalize          norm                    normalize
lerp               vectors                 lerp
project            vectors                 project
angle              angles                  angle
angles             angles                  angle
rotations          rotations               rotation_matrix
quaternion         rotations               rotation_matrix
slerp              slerp                   slerp
euler              euler_angles
obb                shapes                  Obb
plane              shapes                  Plane
aabb               more_shapes             Aabb
ray_box            plain_casts             ray_box
ray_sphere         plain_casts             ray_sphere
ray_triangle       plain_casts             ray_triangle
frustum_culling    plain_camera            is_culled
closest_points     closest_points          closest_points
barycentric        plain_closest           barycentric
bvh                plain_bvh               BvhNode
sphere_box         sphere_box              sphere_box
sat                separating_axes         separating_axes
clipping           face_clipping           face_clipping
gjk                gjk                     gjk
epa                epa                     epa
box_box            box_box                 box_box
contact_reduction  contact_reduction
inertia            mass_properties
friction           friction
world              solvers                 GameWorld
solver             solvers                 GameWorld
WORDS
}

complaints=$(words | while read -r word header first; do
  "$root/cookbook" take "$word" >"$work/taken" 2>"$work/said" || { echo "$word: $(cat "$work/said")"; continue; }
  [ "$(sed -n '1s|^// \([a-z0-9_]*\): .*|\1|p' "$work/taken")" = "$header" ] ||
    echo "$word: $(sed -n 1p "$work/taken"), not $header"
  listed=$(sed -n 's|^//   \([A-Za-z_]*\): .*|\1|p' "$work/taken" | sed -n 1p)
  [ -z "$first" ] || [ "$first" = "$listed" ] || echo "$word: lists $listed first, not $first"
done
# What one line of the table names exists.
sed '/^#/d' "$root/tools/cmake/take_terms.txt" | while read -r word header names; do
  "$root/cookbook" take "$word" >"$work/taken" 2>/dev/null || { echo "$word: there is no $header"; continue; }
  for name in $names; do
    grep -q "^//   $name: " "$work/taken" || echo "$word: $header offers no $name"
  done
done)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }
