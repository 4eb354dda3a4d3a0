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
impulse            impulse                 resolve_collision
restitution        restitution             impact_speed
baumgarte          position_correction     bias_velocity
rk4                integrators             rk4
tunneling          tunnelling
pgs                sequential_impulses
xpbd               plain_positions
step_1             step_1                  World
step_2             step_2                  World
step_3             step_3                  World
step_4             step_4                  World
step_5             step_5                  World
step_6             step_6                  World
step_7             step_7                  World
small_world        small_world             World
game_world         solvers                 GameWorld
solver             solvers                 GameWorld
WORDS
}

complaints=$(words | while read -r word header first; do
  "$root/cookbook" take "$word" >"$work/taken" 2>"$work/said" || { echo "$word: $(cat "$work/said")"; continue; }
  [ "$(sed -n '1s|^// \([a-z0-9_]*\): .*|\1|p' "$work/taken")" = "$header" ] ||
    echo "$word: $(sed -n 1p "$work/taken"), not $header"
  listed=$(sed -n 's|^//   \([A-Za-z_0-9]*\): .*|\1|p' "$work/taken" | sed -n 1p)
  [ -z "$first" ] || [ "$first" = "$listed" ] || echo "$word: lists $listed first, not $first"
done
# Words with more than one meaning get an answer that names what to take instead, and nothing is taken.
while read -r word named; do
  ! "$root/cookbook" take "$word" >"$work/taken" 2>"$work/said" || echo "$word: is taken, as if it had one meaning"
  [ ! -s "$work/taken" ] || echo "$word: prints a header beside its answer"
  grep -q "$named" "$work/said" || echo "$word: the answer names no $named: $(cat "$work/said")"
done <<'WORDS'
world     game_world
sweep     swept_sphere
hull      closest_points
dot       a.dot(b)
euler     integrators
collide   impulse
sleep     small_world
swept     swept_box
contact   contact_reduction
WORDS
# What one line of the table names exists.
sed '/^#/d' "$root/tools/cmake/take_terms.txt" | while read -r word header names; do
  [ "$header" != '?' ] || continue
  "$root/cookbook" take "$word" >"$work/taken" 2>/dev/null || { echo "$word: there is no $header"; continue; }
  for name in $names; do
    [ "$name" = . ] || grep -q "^//   $name: " "$work/taken" || echo "$word: $header offers no $name"
  done
done
# So does what a page tells to take.
cat "$root"/README.md "$root"/docs/*.md "$root"/chapters/*.md |
  grep -oE 'cookbook take [a-z0-9_]+' | sort -u | while read -r _ _ name; do
  "$root/cookbook" take "$name" >/dev/null 2>"$work/said" || echo "a page tells to take $name: $(cat "$work/said")"
done
# ./cookbook list names what is taken for the two worlds.
"$root/cookbook" list >"$work/list"
for name in small_world game_world solvers; do
  grep -qE "(^| )$name(\.hpp|:| )" "$work/list" || echo "list does not name $name"
done)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }
