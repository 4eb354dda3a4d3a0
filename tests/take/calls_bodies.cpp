// Calls what the recipes of chapters 5 and 6 offer, those whose TAKE_… is defined. check_take.sh
// includes their headers: the house's, or one that was taken.

#include "calls.hpp"

#include <array>
#include <vector>

using namespace cookbook;

namespace
{

#if defined TAKE_impulse || defined TAKE_contact_constraint || defined TAKE_friction ||            \
    defined TAKE_restitution || defined TAKE_springs
Body<double> drawn_body(Draw& draw)
{
  const Motion<double> motion{draw.vector(1), draw.vector(2), draw.vector(2)};
  const double mass = draw.number(0.1, 9);
  const MassProperties<double> solid = solid_box<double>(mass, draw.half_extents());
  const Matrix3<double> axes = draw.axes();
  return draw.one_in(8) ? static_body<double>(motion.center) : dynamic_body(motion, solid, axes);
}
#endif

#if defined TAKE_impulse || defined TAKE_friction || defined TAKE_restitution ||                   \
    defined TAKE_springs
/// Two bodies and where they meet.
struct Meeting
{
  BodyPair<double> bodies;
  Vector3<double> normal, point;
};

Meeting drawn_meeting(Draw& draw)
{
  const Body<double> a = drawn_body(draw), b = drawn_body(draw);
  return {{a, b}, draw.unit(), draw.vector(1)};
}

void add(Bits& bits, const BodyPair<double>& bodies)
{
  bits(bodies.a.motion.velocity, bodies.a.motion.angular_velocity);
  bits(bodies.b.motion.velocity, bodies.b.motion.angular_velocity);
}
#endif

#if defined TAKE_weld || defined TAKE_hinge || defined TAKE_slider || defined TAKE_distance ||     \
    defined TAKE_ball_limits || defined TAKE_wheel || defined TAKE_mouse
JointFrame drawn_frame(Draw& draw)
{
  return {draw.vector(1), draw.orientation()};
}

/// Prints the rows of joints that `make(draw)` makes, between bodies that turn.
template <class Make>
void print_rows(const char* name, Make make)
{
  print(
      name,
      [&](Draw& draw, Bits& bits)
      {
        RigidBody a{}, b{};
        for (RigidBody* const body : {&a, &b})
        {
          body->motion = {draw.vector(1), draw.vector(1), draw.vector(1)};
          body->orientation = draw.orientation();
          body->inverse_mass = draw.number(0.1, 9);
          body->inverse_inertia = body->inverse_mass * Matrix3<double>::Identity();
        }
        JointRows rows;
        joint_rows(make(draw), a, b, 1.0 / 60, rows);
        for (const ConstraintRow& row : rows.all())
        {
          const Vector3<double> along = row.b.head<3>(), about = row.b.tail<3>();
          bits(along, about, row.error, row.turning, row.keeps, row.pulls);
        }
      });
}
#endif

#if defined TAKE_sequential_impulses || defined TAKE_soft_steps || defined TAKE_position_based ||  \
    defined TAKE_direct_solver || defined TAKE_wide_solver || defined TAKE_avbd
/// Prints what a solver makes of small piles of boxes, one frame each.
template <class Solver>
void print_piles(const char* name, Solver solver)
{
  const auto pile = [&](Draw& draw, Bits& bits)
  {
    std::vector<RigidBody> bodies;
    std::vector<WorldContact> contacts;
    const int count = 2 + draw.one_in(2) + draw.one_in(2);
    for (int i = 0; i < count; ++i)
    {
      SceneBody body{{}, BoxShape{draw.half_extents()}};
      body.mass = i == 0 || draw.one_in(16) ? 0 : draw.number(0.5, 4);
      body.position = Vector3<double>(0, i, 0) + 0.1 * draw.vector(1);
      body.orientation = draw.orientation();
      body.velocity = draw.vector(1);
      body.angular_velocity = draw.vector(1);
      bodies.push_back(rigid_body(body));
    }
    for (int i = 1; i < count; ++i)
    {
      if (draw.one_in(16) || (is_fixed(bodies[index_of(i - 1)]) && is_fixed(bodies[index_of(i)])))
      {
        continue;
      }
      WorldContact contact{i - 1, i, draw.number(0, 1), draw.number(0, 1), {}, {}};
      const Vector3<double> normal = (draw.vector(0.2) + Vector3<double>(0, 1, 0)).normalized();
      contact.normal = normal;
      for (unsigned corner = 0; corner < 4; ++corner)
      {
        const Vector3<double> at(corner % 2 - 0.5, i - 0.5, corner / 2 - 0.5);
        const Vector3<double> apart = draw.number(-0.05, 0.05) / 2 * normal;
        const RigidBody &a = bodies[index_of(i - 1)], &b = bodies[index_of(i)];
        WorldPoint& point = contact.points.emplace_back();
        point.anchor_a = a.axes.transpose() * (at - apart - a.motion.center);
        point.anchor_b = b.axes.transpose() * (at + apart - b.motion.center);
        point.impulse = point.warm_start_impulse = draw.one_in(2) ? draw.number(0, 0.1) : 0;
        point.solved = point.impulse > 0;
        point.feature = corner;
      }
      contacts.push_back(contact);
    }
    SolverScratch room;
    const IslandView view{bodies, contacts, Vector3<double>(0, -9.81, 0), room};
    Islands islands;
    islands.find(bodies, contacts);
    for (std::size_t i = 0; i < islands.size(); ++i)
    {
      bits(solver(view, islands[i]));
    }
    for (const RigidBody& body : bodies)
    {
      bits(body.motion.center, body.orientation);
      bits(body.motion.velocity, body.motion.angular_velocity);
    }
    for (const WorldContact& contact : contacts)
    {
      for (const WorldPoint& point : contact.points)
      {
        bits(point.impulse, point.friction);
      }
    }
  };
  print(name, pile);
}
#endif

#ifdef TAKE_game_world
/// A solver that pushes eight times at each contact point.
void push_eight_times(IslandView view, const Island& island, double step)
{
  for (const int body : island.bodies)
  {
    view.bodies[index_of(body)].motion.velocity += step * view.gravity;
  }
  const std::span<IslandPoint> points = points_of(view, island);
  for (int i = 0; i < 8; ++i)
  {
    for (IslandPoint& point : points)
    {
      add_impulse(
          point, -point.normal_mass * (separating_velocity(point) + point.separation / step));
      add_friction(point);
    }
  }
  store(points);
  for (const int body : island.bodies)
  {
    integrate_position(view.bodies[index_of(body)], step);
  }
}

GameWorld drawn_world(Draw& draw)
{
  Scene scene;
  scene.bodies.push_back({"ground", PlaneShape{{0, 1, 0}, 0}});
  for (int i = 0; i < 4; ++i)
  {
    SceneBody body{"body", SphereShape{draw.number(0.3, 0.6)}};
    if (draw.one_in(2))
    {
      body.shape = BoxShape{draw.half_extents() / 2};
    }
    body.mass = draw.number(0.5, 4);
    body.position = Vector3<double>(0, 0.8 + i, 0) + 0.2 * draw.vector(1);
    body.orientation = draw.orientation();
    const double fast = draw.one_in(8) ? 20 : 1;
    body.velocity = draw.vector(4) * fast;
    body.angular_velocity = draw.vector(4);
    body.restitution = draw.number(0, 1);
    scene.bodies.push_back(body);
  }
  return GameWorld(scene, push_eight_times, true);
}
#endif

} // namespace

int main()
{
#ifdef TAKE_impulse
  print(
      "impulse",
      [](Draw& draw, Bits& bits)
      {
        const auto [bodies, normal, point] = drawn_meeting(draw);
        add(bits, resolve_collision(bodies, normal, point, draw.number(0, 1)));
      });
#endif
#ifdef TAKE_friction
  print(
      "friction",
      [](Draw& draw, Bits& bits)
      {
        const auto [bodies, normal, point] = drawn_meeting(draw);
        auto [a, b] = bodies;
        const Arms<double> arms = arms_to(bodies, point);
        const SurfaceAxes<double> surface = surface_axes(normal);
        const SlidingMass<double> mass = sliding_mass(a, b, surface, arms);
        const Vector2<double> accumulated = surface.along(0.1 * draw.unit());
        const Vector2<double> sliding = sliding_velocity(a, b, surface, arms);
        const Vector3<double> impulse =
            surface.in_world(friction_impulse(sliding, mass, accumulated, draw.number(0, 2)));
        bits(mass.smallest, impulse);
        apply_impulse(a, b, arms, impulse);
        add(bits, BodyPair<double>{a, b});
      });
#endif
#ifdef TAKE_contact_constraint
  print(
      "contact_constraint",
      [](Draw& draw, Bits& bits)
      {
        Body<double> a = drawn_body(draw), b = drawn_body(draw);
        ContactConstraint<double> contact{};
        contact.normal = draw.unit();
        contact.surface = surface_axes(contact.normal);
        contact.arms = {draw.vector(1), draw.vector(1)};
        contact.coefficient = draw.number(0, 1);
        contact.impulse = draw.number(0, 1);
        contact.friction = contact.surface.along(0.1 * draw.unit());
        compute_masses(contact, a, b);
        warm_start(a, b, contact);
        const double velocity = separating_velocity(a, b, contact);
        add_impulse<double>(a, b, contact, -contact.normal_mass * velocity);
        add_friction(a, b, contact);
        bits(contact.impulse, contact_impulse(contact));
        bits(a.motion.velocity, a.motion.angular_velocity);
        bits(b.motion.velocity, b.motion.angular_velocity);
      });
#endif
#ifdef TAKE_restitution
  print(
      "restitution",
      [](Draw& draw, Bits& bits)
      {
        const auto [bodies, normal, point] = drawn_meeting(draw);
        const ContactStep<double> step{draw.number(-10, 0), 1.0 / 60, draw.number(-0.1, 0.1)};
        const double back = draw.number(0, 0.9),
                     slowest = restitution_threshold(9.81, step.duration);
        const double speed =
            separating_velocity(bodies.a, bodies.b, normal, arms_to(bodies, point));
        const double target = rebound_speed(speed, step, back, slowest);
        bits(target, settling_time(draw.number(0.1, 2), 9.81, back));
        add(bits, with_separating_velocity(bodies, normal, point, target));
      });
#endif
#ifdef TAKE_mass_properties
  print(
      "mass_properties",
      [](Draw& draw, Bits& bits)
      {
        const double mass = draw.number(0.1, 9), radius = draw.number(0.1, 2);
        const MassProperties<double> box = solid_box<double>(mass, draw.half_extents());
        const MassProperties<double> capsule = solid_capsule(mass, draw.number(0, 2), radius);
        bits(solid_sphere(mass, radius).moments, box.moments, capsule.moments);
        bits(world_inertia<double>(box.moments, draw.axes()));
      });
#endif
#ifdef TAKE_small_world
  print(
      "small_world",
      [](Draw& draw, Bits& bits)
      {
        small_world::World world;
        small_world::add(world, small_world::box({0, -1, 0}, {9, 1, 9}, 0));
        for (int i = 0; i < 3; ++i)
        {
          const Vector3<double> center = draw.vector(0.2) + Vector3<double>(0, 0.6 + i, 0);
          const double mass = draw.number(0.5, 4);
          small_world::add(
              world, draw.one_in(2) ? small_world::box(center, draw.half_extents(), mass)
                                    : small_world::sphere(center, draw.number(0.1, 0.5), mass));
        }
        small_world::step(world, 1.0 / 60);
        small_world::step(world, 1.0 / 60);
        for (const small_world::RigidBody& body : world.bodies)
        {
          bits(body.motion.center, body.motion.velocity, body.motion.angular_velocity);
        }
      });
#endif
#ifdef TAKE_game
  print(
      "game",
      [](Draw& draw, Bits& bits)
      {
        const double y = draw.number(0.5, 2);
        game::Game played = game::start(
            {"one brick", 1, {{game::Material::wood, {9, y}, {0.2, 0.5}}}, {{{10, 0.5}, 0.4, 50}}});
        game::aim(played, {draw.number(-1.2, -0.8), draw.number(-0.4, 0)});
        game::shoot(played);
        for (int i = 0; i < 60; ++i)
        {
          game::step(played);
        }
        bits(played.world.bodies[1].motion.center, played.world.bodies[3].motion.center);
        bits(played.points);
      });
#endif
#ifdef TAKE_integrators
  print(
      "integrators",
      [](Draw& draw, Bits& bits)
      {
        using Point = PhasePoint<Eigen::Vector3d>;
        const Point from{draw.vector(1), draw.vector(1)};
        const double step = draw.number(0, 0.6);
        const auto pull = [](const Eigen::Vector3d& position, const Eigen::Vector3d& velocity)
        { return Eigen::Vector3d(-9 * position - 0.1 * velocity); };
        for (const Point& to :
             {symplectic_euler(from, step, pull), velocity_verlet(from, step, pull),
              rk4(from, step, pull), explicit_euler(from, step, pull)})
        {
          bits(to.position, to.velocity);
        }
      });
#endif
#ifdef TAKE_damping
  print(
      "damping",
      [](Draw& draw, Bits& bits)
      {
        const PhasePoint<Eigen::Vector3d> from{draw.vector(1), draw.vector(1)};
        const Eigen::Vector3d gravity(0, -9.81, 0);
        const double rate = draw.number(0, 3), time = draw.number(0, 2);
        const PhasePoint<Eigen::Vector3d> to = damped_fall(from, gravity, rate, time);
        bits(to.position, to.velocity, implicit_damping_factor(rate, time));
        bits(damped_kick(from.velocity, gravity, damping_factor(rate, time), time));
      });
#endif
#ifdef TAKE_position_correction
  print(
      "position_correction",
      [](Draw& draw, Bits& bits)
      {
        const double frequency = draw.number(0, 60), ratio = draw.number(0, 5);
        const Softness<double> soft = softness(frequency, ratio, 1.0 / 60);
        const double depth = draw.number(-0.5, 0.5);
        const double mass = draw.number(0, 2), speed = draw.number(-1, 1);
        const double bias = bias_velocity(depth, 0.005, soft.bias_rate, 3.0);
        bits(soft.bias_rate, soft.mass_scale, soft.impulse_scale, bias);
        bits(position_correction(depth, 0.005, 0.2));
        bits(soft_change(soft, mass, speed, bias, draw.number(0, 1)));
      });
#endif
#ifdef TAKE_sleeping
  print(
      "sleeping",
      [states = std::vector<SleepState<double>>(6)](Draw& draw, Bits& bits) mutable
      {
        const SleepLimits<double> limits{0.05, 0.02, 0.05, 0.2};
        const std::array<std::pair<int, int>, 2> touching{{{1, 2}, {3, 4}}};
        const std::vector<bool> movable{false, true, true, true, true, true};
        const std::vector<int> numbers = islands(movable, touching);
        for (std::size_t i = 1; i < states.size(); ++i)
        {
          const double size = draw.one_in(40) ? 1 : 0.005;
          const Vector3<double> velocity = size * draw.vector(1), spin = size * draw.vector(1);
          states[i] = update_sleep_state<double>(states[i], velocity, spin, 1, 1.0 / 60, limits);
        }
        update_sleep(states, numbers, limits);
        if (draw.one_in(20))
        {
          wake(states, numbers, 1);
        }
        for (const SleepState<double>& state : states)
        {
          bits(
              state.velocity, state.angular_velocity, state.displacement, state.time_at_rest,
              state.asleep);
        }
      });
#endif
#ifdef TAKE_spinning_bodies
  print(
      "spinning_bodies",
      [](Draw& draw, Bits& bits)
      {
        const Spinning<double> from{draw.orientation(), draw.vector(20)};
        const Vector3<double> moments = draw.half_extents();
        for (const Spinning<double>& to :
             {turned(from, moments, 1.0 / 60), turned_finely(from, moments, 1.0 / 60)})
        {
          bits(to.orientation, to.angular_velocity);
        }
      });
#endif
#ifdef TAKE_tunnelling
  print(
      "tunnelling",
      [](Draw& draw, Bits& bits)
      {
        const std::array<Obb<double>, 2> walls{draw.box<Obb>(), draw.box<Obb>()};
        const MovingSphere<double> from{{3 * draw.unit(), draw.number(0.1, 0.4)}, draw.vector(200)};
        const MovingSphere<double> aimed{
            from.sphere, -100 * from.sphere.center + 0.1 * from.velocity};
        const double step = 1.0 / 60;
        for (const MovingSphere<double>& to :
             {swept_step<double>(aimed, walls, 0.5, step), substeps(aimed, walls[0], 0.5, step, 4),
              speculative_step(aimed, walls[0], 0.5, step, 5.0)})
        {
          bits(to.sphere.center, to.velocity);
        }
      });
#endif
#ifdef TAKE_sequential_impulses
  print_piles(
      "sequential_impulses",
      [](IslandView view, const Island& island)
      {
        sequential_impulses(view, island, 1.0 / 60, SequentialSettings{});
        return true;
      });
#endif
#ifdef TAKE_weld
  print_rows(
      "weld",
      [](Draw& draw) {
        return WeldJoint{0, 1, drawn_frame(draw), drawn_frame(draw)};
      });
#endif
#ifdef TAKE_hinge
  print_rows(
      "hinge",
      [](Draw& draw)
      {
        HingeJoint hinge{0, 1, drawn_frame(draw), drawn_frame(draw)};
        hinge.drive = {.lower = -1, .upper = 1, .stiffness = draw.number(0, 99), .damping = 1};
        return hinge;
      });
#endif
#ifdef TAKE_slider
  print_rows(
      "slider",
      [](Draw& draw)
      {
        SliderJoint slider{0, 1, drawn_frame(draw), drawn_frame(draw)};
        slider.drive = {.upper = 1, .motor_speed = draw.number(-1, 1), .motor_force = 2};
        return slider;
      });
#endif
#ifdef TAKE_distance
  print_rows(
      "distance",
      [](Draw& draw)
      {
        DistanceJoint rope{0, 1, draw.vector(1), draw.vector(1)};
        rope.most = draw.number(0, 2);
        return rope;
      });
#endif
#ifdef TAKE_ball_limits
  print_rows(
      "ball_limits",
      [](Draw& draw)
      {
        ConeTwistJoint shoulder{0, 1, drawn_frame(draw), drawn_frame(draw)};
        shoulder.cone = draw.number(0, 3);
        shoulder.twist = {.lower = -0.5, .upper = 0.5};
        return shoulder;
      });
#endif
#ifdef TAKE_wheel
  print_rows(
      "wheel",
      [](Draw& draw)
      {
        WheelJoint wheel{0, 1, drawn_frame(draw), drawn_frame(draw)};
        wheel.suspension = {.stiffness = 2500, .damping = 250};
        wheel.steering = draw.number(-1, 1);
        return wheel;
      });
#endif
#ifdef TAKE_mouse
  print_rows("mouse", [](Draw& draw) { return MouseJoint{0, 1, draw.vector(1), draw.vector(1)}; });
#endif
#ifdef TAKE_springs
  print(
      "springs",
      [](Draw& draw, Bits& bits)
      {
        const auto [frequency, ratio] = spring_numbers(draw.number(1, 999), 2.0, 3.0);
        const auto spring = spring_coefficients(frequency, ratio, 1.0 / 60);
        auto [bodies, normal, point] = drawn_meeting(draw);
        const double load = load_speed(spring, frequency, 1.0 / 60, 9.81);
        const double impulse = apply_spring<double>(
            bodies.a, bodies.b, {point, point + normal}, draw.number(0, 2), spring, load);
        add(bits, bodies);
        bits(impulse);
      });
#endif
#ifdef TAKE_first_joint
  print(
      "first_joint",
      [](Draw& draw, Bits& bits)
      {
        PhasePoint<Vector3<double>> at{draw.vector(1), draw.vector(2)};
        const Rod<double> rod{draw.number(0.2, 2), draw.number(0, 1)};
        for (int step = 0; step < 4; ++step)
        {
          at = rod_step<double>(at, rod, {0, -9.81, 0}, 1.0 / 60);
        }
        bits(at.position, at.velocity);
      });
#endif
#ifdef TAKE_articulated
  print(
      "articulated",
      [](Draw& draw, Bits& bits)
      {
        std::vector<Link> links(4);
        for (std::size_t i = 0; i < links.size(); ++i)
        {
          links[i].parent = i == 0 ? -1 : 0;
          links[i].joint = i % 2 == 0 ? JointType::hinge : JointType::slider;
          links[i].solid = solid_box<double>(draw.number(0.1, 9), draw.half_extents());
          links[i].anchor_parent = draw.vector(1);
          links[i].anchor_child = draw.vector(1);
        }
        ArticulatedBody tree(links);
        TreeState state = zero_state(links);
        state.velocities[0] = draw.number(-2, 2);
        semi_implicit_step(tree, state, 1.0 / 240);
        rk4_step(tree, state, 1.0 / 240);
        for (int i = 0; i < 4; ++i)
        {
          bits(state.positions[i], state.velocities[i]);
        }
      });
#endif
#ifdef TAKE_joints
  print(
      "joints",
      [](Draw& draw, Bits& bits)
      {
        FramePose pose{};
        pose.a = draw.axes();
        pose.b = draw.axes();
        pose.turned = Quaternion<double>(Matrix3<double>(pose.a.transpose() * pose.b));
        JointRows rows;
        add_turn_rows(pose, rows);
        add_swing_rows(pose, rows);
        rows.add(twist_row(pose, with_turns(twist_of(pose), 20)));
        for (const ConstraintRow& row : rows.all())
        {
          const Vector3<double> about = row.b.tail<3>();
          bits(about, row.error);
        }
      });
#endif
#ifdef TAKE_ball_joint
  print(
      "ball_joint",
      [](Draw& draw, Bits& bits)
      {
        RigidBody a{}, b{};
        for (RigidBody* const body : {&a, &b})
        {
          body->motion = {draw.vector(1), draw.vector(1), draw.vector(1)};
          body->orientation = draw.orientation();
        }
        const Anchors anchors = anchors_of(a, b, draw.vector(1), Vector3<double>(1, 2, 3));
        bits(anchors.error, anchors.arms.a, anchors.arms.b);
      });
#endif
#ifdef TAKE_soft_steps
  print_piles(
      "soft_steps",
      [](IslandView view, const Island& island)
      {
        soft_steps(view, island, 1.0 / 60, SoftSettings{});
        return true;
      });
#endif
#ifdef TAKE_wide_solver
  print_piles(
      "wide_solver",
      [lanes = WideContacts()](IslandView view, const Island& island) mutable
      {
        wide_steps(view, {&island, 1}, 1.0 / 60, SoftSettings{}, lanes);
        return true;
      });
#endif
#ifdef TAKE_contact_graph
  print(
      "contact_graph",
      [](Draw& draw, Bits& bits)
      {
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < 20; ++i)
        {
          pairs.emplace_back(
              draw.one_in(2) + 2 * draw.one_in(2), 4 + draw.one_in(2) + 2 * draw.one_in(4));
        }
        ContactGraph graph;
        graph.color(8, pairs, [](int body) { return body > 0; });
        for (const int color : graph.color_of_each())
        {
          bits(color);
        }
      });
#endif
#ifdef TAKE_position_based
  print_piles(
      "position_based",
      [](IslandView view, const Island& island)
      {
        position_based(view, island, 1.0 / 60, PositionSettings{});
        return true;
      });
#endif
#ifdef TAKE_direct_solver
  print_piles(
      "direct_solver", [solver = DirectSolver()](IslandView view, const Island& island) mutable
      { return solver.solve(view, island, 1.0 / 60); });
#endif
#ifdef TAKE_contact_events
  print(
      "contact_events",
      [events = ContactEvents()](Draw& draw, Bits& bits) mutable
      {
        std::vector<WorldContact> contacts;
        SceneBody ball;
        ball.shape = SphereShape{1};
        const std::vector<RigidBody> bodies(5, rigid_body(ball));
        for (int b = 1; b < 5; ++b)
        {
          WorldContact contact{};
          contact.b = b;
          contact.points.emplace_back().impulse = draw.number(-1, 1);
          contacts.push_back(contact);
        }
        events.update(contacts, bodies);
        bits(int(events.active().size()), int(events.begun().size()), int(events.ended().size()));
      });
#endif
#ifdef TAKE_taut
  print(
      "taut",
      [](Draw& draw, Bits& bits)
      {
        const TautLink link{draw.number(0, 1e5), draw.number(0.1, 9), draw.number(0.01, 9)};
        const HangingBridge bridge{
            .planks = 8, .length = draw.number(0.5, 2), .load = draw.number(0, 1e3), .span = 3.5};
        bits(zigzag_rate(link), tension_limit(link, draw.number(0.001, 0.1)), sag_of(bridge));
      });
#endif
#ifdef TAKE_avbd
  print_piles(
      "avbd",
      [solver = Avbd()](IslandView view, const Island& island) mutable
      {
        solver(view, island, 1.0 / 60);
        return true;
      });
#endif
#ifdef TAKE_rope
  print(
      "rope",
      [](Draw& draw, Bits& bits)
      {
        Rope rope = make_rope(draw.vector(1), draw.vector(1), 8, draw.number(0.1, 9), 1e-3);
        rope.particles.inverse_masses[0] = 0;
        const StepSettings settings{.substeps = 2, .iterations = 2};
        for (int step = 0; step < 4; ++step)
        {
          step_xpbd(rope.particles, rope.links, settings);
          step_direct(rope.particles, rope.links, settings);
          step_implicit(rope.particles, rope.links, settings);
          step_mass_spring(rope.particles, rope.links, settings);
        }
        for (std::size_t i = 0; i <= 8; ++i)
        {
          bits(rope.particles.positions[i], rope.particles.velocities[i]);
        }
      });
#endif
#ifdef TAKE_cloth
  print(
      "cloth",
      [](Draw& draw, Bits& bits)
      {
        Cloth cloth = make_cloth(
            {.corner = {-0.5, 0.3, -0.5}, .columns = 5, .rows = 4, .mass = draw.number(0.1, 9)});
        cloth.particles.inverse_masses[0] = 0;
        Obstacles on{.spheres = {{0.1 * draw.vector(1), 0.2}}};
        on.boxes = {{draw.vector(0.5), draw.axes(), 0.1 * draw.half_extents()}};
        for (int step = 0; step < 4; ++step)
        {
          step_cloth(cloth, {.substeps = 4}, on, {.wind = draw.vector(4)});
        }
        for (std::size_t i = 0; i < 20; ++i)
        {
          bits(cloth.particles.positions[i], cloth.particles.velocities[i]);
        }
      });
#endif
#ifdef TAKE_game_world
  print(
      "game_world",
      [world = std::optional<GameWorld>(), frame = 0](Draw& draw, Bits& bits) mutable
      {
        if (frame++ % 50 == 0)
        {
          world.emplace(drawn_world(draw));
        }
        world->step();
        for (const RigidBody& body : world->bodies())
        {
          bits(body.motion.center, body.orientation);
          bits(body.motion.velocity, body.motion.angular_velocity);
        }
      });
#endif
}
