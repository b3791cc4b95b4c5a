/*
 * The runtime of learned policies, in two parts.
 *
 * For any problem: TPG_VERSION and tpg_version, the codes from TPG_OK on, and networks in integers (tpg_network_t and
 * tpg_network_*). Graphs that tpg-codegen compiled need nothing of this library.
 *
 * For the arm, everything else: kinematics and steps (tpg_arm_*), observation (tpg_observe, tpg_observation_*, tpg_memo_*),
 * generated policies and networks that drive it (tpg_policy_*, tpg_sac_*), two that share it (tpg_hybrid_*, tpg_switch_*),
 * the watch over its motors (tpg_watchdog_*), the arm among moving balls (tpg_body_*, tpg_dodger_*).
 *
 * Every function answers TPG_OK or says by a code why it did nothing. A pointer that is NULL or misaligned gives TPG_NULL or
 * TPG_MISALIGNED. No other bad pointer can be noticed: one must point to as much memory as its type, and the length beside
 * it, say, and no two to memory that overlaps and is written, but where a function says so.
 * Opaque structures are initialised before use: zero one first if it may be used before (TPG_STATE is the answer then).
 *
 * All memory is the caller's; there is no heap and no variable. Nothing behind a pointer to const is ever written. So any
 * number of tasks may share a tpg_arm_t, tpg_body_t, tpg_sac_t, tpg_network_t, tpg_policy_t, tpg_dodge_policy_t, a model and
 * settings. Each task needs its own tpg_hybrid_t, tpg_switch_t, tpg_watchdog_t, tpg_dodger_t, tpg_memo_t and scratch
 * memory: two tasks must not use one of these at the same time.
 *
 * Readings that cannot be move nothing: a decision answers TPG_BAD_TARGET, TPG_BAD_SENSOR or TPG_STUCK with a move of zero,
 * and what it keeps is as before. docs/sensors.md has the whole contract, and how a caller recovers.
 *
 * Made by cbindgen; do not edit.
 */


#ifndef TPG_RUNTIME_H
#define TPG_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

// Version of this header.
#define TPG_VERSION 256

// Joints: base, shoulder, elbow, wrist.
#define TPG_JOINTS 4

// Words of a tpg_arm_t.
#define TPG_ARM_WORDS 22

// The step was done.
#define TPG_VALID 0

// The base would have left its range; the other joints moved.
#define TPG_LIMIT_BASE 1

// The shoulder would have left its range; the other joints moved.
#define TPG_LIMIT_SHOULDER 2

// The elbow would have left its range; the other joints moved.
#define TPG_LIMIT_ELBOW 3

// The wrist would have left its range; the other joints moved.
#define TPG_LIMIT_WRIST 4

// A joint or the hand's tip would be below the table; nothing moved.
#define TPG_COLLISION_TABLE 5

// A corner of the hand would be below the table; nothing moved.
#define TPG_COLLISION_CORNER 6

// Hand or forearm would meet the arm's own base; nothing moved.
#define TPG_COLLISION_BASE 7

// All went well.
#define TPG_OK 0

// A pointer is NULL.
#define TPG_NULL 1

// A pointer is not aligned for its type.
#define TPG_MISALIGNED 2

// A buffer is too short, or longer than memory can be.
#define TPG_LENGTH 3

// A structure was not initialised, or not by this version of the library.
#define TPG_STATE 4

// A number outside the accepted range.
#define TPG_ARGUMENT 5

// The words are no model: they do not begin like one.
#define TPG_MODEL 6

// The model is damaged: its checksum is another.
#define TPG_MODEL_CHECKSUM 7

// The model was made for another problem: other inputs, or another kind of answer.
#define TPG_MODEL_FEATURES 8

// The model's layers do not fit each other, or exceed what the library takes.
#define TPG_MODEL_LAYERS 9

// The model is of another version of the format than this library's: pack it again.
#define TPG_MODEL_VERSION 10

// The target is no number, or farther from the shoulder than the stretched arm reaches. Nothing may move.
#define TPG_BAD_TARGET 11

// A motor is outside its joint's range, or hand, target and difference of an observation do not belong together. Nothing
// may move.
#define TPG_BAD_SENSOR 12

// The motors are not where the commands led them: stuck, moved by something else, or read too late. Nothing may move.
#define TPG_STUCK 13

// Most balls that are seen.
#define TPG_BALLS 3

// Most poses that solve a task.
#define TPG_GOALS 4

// Parts of a body: shoulder to bracket, bracket to elbow, forearm, hand.
#define TPG_CAPSULES 4

// Goal less pose of base, shoulder, elbow and wrist, ticks.
#define TPG_SOURCE_LEFT 32

// Of the nearest ball: clearance, its change in a step, by how much each joint changes it: 6 values in mm, mm/step, mm/rad.
#define TPG_SOURCE_NEAR 33

// Of the second nearest ball: clearance and its change in a step.
#define TPG_SOURCE_SECOND 34

// Steps until the straight walk and the plan meet something, and until the plan arrives.
#define TPG_SOURCE_AHEAD 35

// Steps since the arm was nearer to its goal than ever.
#define TPG_SOURCE_PROGRESS 36

// Steps of the plan less those of the straight walk.
#define TPG_SOURCE_DETOUR 37

// Follows the plan that the search has found.
#define TPG_BEHAVIOUR_PLAN 0

// Walks straight to the goal.
#define TPG_BEHAVIOUR_STRAIGHT 1

// Stays.
#define TPG_BEHAVIOUR_HOLD 2

// Flees from the nearest ball.
#define TPG_BEHAVIOUR_AWAY 3

// Walks to the goal in the potential field.
#define TPG_BEHAVIOUR_FIELD 4

// Follows the plan in the potential field.
#define TPG_BEHAVIOUR_FIELD_PLAN 5

// Stretches upwards in the potential field.
#define TPG_BEHAVIOUR_UPRIGHT 6

// Goes in the field to the goal with the base moved 200 ticks up from where it is. The seven after it: base down, shoulder up
// and down, elbow up and down, wrist up and down.
#define TPG_BEHAVIOUR_FIELD_BASE_UP 7

// Number of behaviours.
#define TPG_BEHAVIOURS 15

// Words of a tpg_body_t.
#define TPG_BODY_WORDS 38

// Words of a tpg_dodger_t.
#define TPG_DODGER_WORDS 42

// The network keeps the arm until the episode ends.
#define TPG_NEVER 4294967295

// Every action of the graph is executed.
#define TPG_GUARD_NONE 0

// The network takes over instead of an action of the graph that leaves a joint's range.
#define TPG_GUARD_JOINT_LIMITS 1

// Nor one that collides.
#define TPG_GUARD_COLLISIONS 2

// And the network holds joints where that makes its action valid.
#define TPG_GUARD_BOTH 3

// The graph acts.
#define TPG_DRIVER_GRAPH 0

// The network acts.
#define TPG_DRIVER_NETWORK 1

// Causes of a hand-over: guard, drift, stop, cycle.
#define TPG_CAUSES 4

// Words of a tpg_hybrid_t.
#define TPG_HYBRID_WORDS 28

// Words of a tpg_switch_t.
#define TPG_SWITCH_WORDS 17

// Words of a tpg_memo_t.
#define TPG_MEMO_WORDS 12

// Words of a tpg_network_t.
#define TPG_NETWORK_WORDS 26

// The most floats that the sources of a policy may have together.
#define TPG_STATE_LENGTH 48

// The target: x, y, z in mm.
#define TPG_SOURCE_TARGET 0

// Target - hand: x, y, z in mm.
#define TPG_SOURCE_DIFFERENCE 1

// The hand's tip: x, y, z in mm.
#define TPG_SOURCE_HAND 2

// The four motor positions, ticks.
#define TPG_SOURCE_MOTORS 3

// All six servos, ticks.
#define TPG_SOURCE_SERVOS 4

// Errors in the shoulder's polar frame, 3 values in mm.
#define TPG_SOURCE_POLAR 5

// Height of the hand's lower corner, 1 value in mm.
#define TPG_SOURCE_FLOOR 6

// By how many ticks all four joints are off from a pose that reaches the target.
#define TPG_SOURCE_STANCE 7

// Words of a tpg_sac_t.
#define TPG_SAC_WORDS 30

// Default threshold of a tpg_watch_t, ticks: 2.8 degrees.
#define TPG_WATCH_THRESHOLD 32

// Default patience of a tpg_watch_t, steps.
#define TPG_WATCH_PATIENCE 64

// A threshold that never finds a motor stuck, ticks.
#define TPG_WATCH_NEVER 4096

// Words of a tpg_watchdog_t.
#define TPG_WATCHDOG_WORDS 6

// An arm, ready for use. Opaque; initialised by tpg_arm_init or tpg_arm_init_widowx, constant from then on.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_ARM_WORDS];
} tpg_arm_t;

// Motor positions, ticks of 1/4096 turn; 2048 is the middle of a joint's travel, 0 rad.
typedef struct {
  // Base, shoulder, elbow, wrist.
  int16_t ticks[TPG_JOINTS];
} tpg_pose_t;

// A horizontal or vertical edge of the base's outline in the arm plane, mm.
typedef struct {
  // The two ends' distances from the base's axis.
  float x[2];
  // The two ends' heights over the table.
  float z[2];
} tpg_edge_t;

// An arm as data: a base that turns, and shoulder, elbow and wrist in one vertical plane. Lengths in mm.
typedef struct {
  // The pose in which a fixed-start episode begins.
  tpg_pose_t home;
  // Positions of the servos that never move (wrist rotation, gripper), ticks.
  int16_t fixed_servos[2];
  // Lowest positions of the joints, ticks.
  int16_t min[TPG_JOINTS];
  // Highest positions of the joints, ticks.
  int16_t max[TPG_JOINTS];
  // Height of the shoulder over the table.
  float base;
  // Shoulder to the elbow's bracket.
  float upper_arm;
  // Bracket to the elbow, at a right angle to the upper arm.
  float elbow_offset;
  // Elbow to wrist.
  float forearm;
  // Wrist to the hand's tip.
  float hand;
  // Wrist to the face of the hand's tip.
  float hand_length;
  // From the hand's axis to its long edges, positive upwards with the arm stretched forwards.
  float hand_edges[2];
  // Distance of the forearm's end face beyond the wrist.
  float forearm_overhang;
  // From the forearm's axis to its long edges.
  float forearm_edges[2];
  // The outline of the base, one side.
  tpg_edge_t base_edges[4];
  // Distance of the shoulder in front of the base's axis, at which the base turns it round. 0 in many arms.
  float shoulder_radial;
} tpg_arm_description_t;

// A change of the motor positions, which an action asks for.
typedef struct {
  // A change for each joint, ticks.
  int8_t ticks[TPG_JOINTS];
} tpg_move_t;

// An arm whose links are capsules. Opaque; initialised by tpg_body_init, constant from then on.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_BODY_WORDS];
} tpg_body_t;

// The state of a control loop among balls towards one target: the search, the places where the motors should be, the goals.
// Opaque; initialised by tpg_dodger_init for every target. It belongs to one task.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_DODGER_WORDS];
} tpg_dodger_t;

// A generated `PREFIX_infer` behind a pointer of one type for all: `return (uint16_t)PREFIX_infer(state);`.
typedef uint16_t (*tpg_infer_t)(const void *state);

// A policy that tpg-codegen compiled, in f32, whose actions are behaviours. Constant: it can lie in flash.
typedef struct {
  // The decision. Its argument points to the sources' values, aligned for the generated structure.
  tpg_infer_t infer;
  // TPG_SOURCE codes from TPG_SOURCE_LEFT to TPG_SOURCE_DETOUR, in order; 17 values at most.
  const uint8_t *sources;
  // Number of sources.
  size_t source_count;
  // A TPG_BEHAVIOUR code for each action. An action past the end holds.
  const uint8_t *behaviours;
  // Number of behaviours.
  size_t behaviour_count;
} tpg_dodge_policy_t;

// Settings of search and guard.
typedef struct {
  // The cost that a whole step may have, in instructions of a Cortex-M4, about: 4000 to 60000.
  uint16_t effort;
  // 1 if steps that would soon be hit are replaced, 0 if not.
  uint8_t guard;
} tpg_dodger_settings_t;

// The difference that commanded and observed motion may have.
typedef struct {
  // Ticks that a motor may be away from where the commands led it, up to TPG_WATCH_NEVER.
  uint16_t threshold;
  // Steps over which differences add up, from 1; then the comparison starts anew from where the motors are. With a
  // patience greater than the threshold a motor is found that is asked for a tick a step and does not move.
  uint16_t patience;
} tpg_watch_t;

// A ball as it is seen.
typedef struct {
  // Its centre: x, y, z in mm; at most 100 m away.
  float at[3];
  // Its displacement in the last step, mm; at most 1 m.
  float velocity[3];
  // Its radius, mm; above 0, at most 1 m.
  float radius;
} tpg_ball_t;

// A step of a control loop among balls.
typedef struct {
  // The move that goes to the motors: never against limits, table or base.
  tpg_move_t wanted;
  // The TPG_BEHAVIOUR that the policy chose.
  uint8_t behaviour;
} tpg_dodge_t;

// A policy and a network with their settings. Opaque; initialised by tpg_hybrid_init.
//
// It belongs to one task: it keeps what it has computed about the target. Two tasks need two hybrids with a scratch memory
// each; they may share arm, policy and network.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_HYBRID_WORDS];
} tpg_hybrid_t;

// A policy that tpg-codegen compiled, in f32. Constant: it can lie in flash.
typedef struct {
  // The decision. Its argument points to the sources' values, aligned for the generated structure.
  tpg_infer_t infer;
  // TPG_SOURCE codes, in order: PREFIX_SOURCES of the generated header.
  const uint8_t *sources;
  // Number of sources.
  size_t source_count;
  // The move of each action: PREFIX_MOVES of the generated header. An action past the end moves nothing.
  const tpg_move_t *moves;
  // Number of moves.
  size_t move_count;
} tpg_policy_t;

// The arm's network in integers, checked. Opaque; initialised by tpg_sac_init, constant from then on.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_SAC_WORDS];
} tpg_sac_t;

// The times at which graph and network change, and the guard.
typedef struct {
  // Actions of the network before the graph is asked again, from 1; with TPG_NEVER the network keeps the arm.
  uint32_t hand_back_after;
  // The network takes over when the distance exceeds the best one so far by more than this, mm.
  float separation;
  // A TPG_GUARD code.
  int32_t guard;
} tpg_settings_t;

// The state of a control loop towards one target: the one whose turn it is, the last move that was commanded, the places
// where the motors should be, and poses at which the hybrid's arm is free. So it goes with no other hybrid.
// Opaque; initialised by tpg_switch_init for every target.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_SWITCH_WORDS];
} tpg_switch_t;

// The arm and its target as a policy sees them. tpg_observe makes one; fill in none by hand.
typedef struct {
  // Motor positions.
  tpg_pose_t pose;
  // Positions of the servos that never move, ticks.
  int16_t fixed_servos[2];
  // The hand's tip, mm.
  float hand[3];
  // The target, mm.
  float target[3];
  // Target - hand, mm.
  float difference[3];
} tpg_observation_t;

// An action, and the one that chose it.
typedef struct {
  // The move that goes to the motors.
  tpg_move_t wanted;
  // A TPG_DRIVER code.
  int32_t driver;
} tpg_chosen_t;

// Actions of each, and the reasons of their changes.
typedef struct {
  // Actions of the graph.
  uint32_t graph_actions;
  // Actions of the network.
  uint32_t network_actions;
  // Hand-overs to the network: guard, drift, stop, cycle.
  uint32_t hand_overs[TPG_CAUSES];
  // Times that the network gave the arm back.
  uint32_t hand_backs;
} tpg_counts_t;

// Values about a target, kept while decisions ask for the same one. It changes no result and saves most of the
// cost of sources that take inverse tangents or collision tests. Opaque; initialised by tpg_memo_init. For one task at a
// time.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_MEMO_WORDS];
} tpg_memo_t;

// A network in integers, checked. Opaque; initialised by tpg_network_init, constant from then on.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_NETWORK_WORDS];
} tpg_network_t;

// The watch over an arm's motors, for control loops without a hybrid: tpg_watchdog_check before every decision,
// tpg_watchdog_commanded after it. A tpg_switch_t holds one of its own. Opaque; initialised by tpg_watchdog_init.
typedef struct {
  // The library's.
  uint64_t opaque[TPG_WATCHDOG_WORDS];
} tpg_watchdog_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Version of the library, for comparison with TPG_VERSION: major << 16, minor << 8, patch.
uint32_t tpg_version(void);

// Makes the paper's arm, a WidowX with four joints.
int32_t tpg_arm_init_widowx(tpg_arm_t *arm);

// Makes an arm of your own. TPG_ARGUMENT for one that cannot be:
//
// - a joint's range that is empty or goes beyond 0 to 4095, or a home position outside it;
// - a length that is not finite, or above 100 m: all of them. Not above 0: upper arm, forearm and hand. Below 0: the
//   base's height, the elbow's offset and the shoulder's distance from the base's axis;
// - an edge of the base that is neither horizontal nor vertical.
int32_t tpg_arm_init(tpg_arm_t *arm, const tpg_arm_description_t *description);

// The pose in which a fixed-start episode begins.
int32_t tpg_arm_home(const tpg_arm_t *arm, tpg_pose_t *pose);

// Forward kinematics: the place of the hand's tip at a pose; x, y, z in mm.
int32_t tpg_arm_hand(const tpg_arm_t *arm, const tpg_pose_t *pose, float *hand);

// Tests whether the arm collides at a pose: TPG_VALID or a code of TPG_COLLISION.
int32_t tpg_arm_collision(const tpg_arm_t *arm, const tpg_pose_t *pose, int32_t *collision);

// Tries a move: the pose afterwards, and TPG_VALID, or a code of TPG_LIMIT or TPG_COLLISION.
//
// A joint that would leave its range stays, the others still move; if the arm then collides, the whole move is taken
// back. `pose` and `after` may be the same.
int32_t tpg_arm_step(const tpg_arm_t *arm,
                     const tpg_pose_t *pose,
                     const tpg_move_t *wanted,
                     tpg_pose_t *after,
                     int32_t *validity);

// Gives an arm a body: a capsule around each of its links. `radii` are TPG_CAPSULES numbers, mm, or NULL: those of the WidowX.
// TPG_ARGUMENT for a radius that is not above 0 and at most 1 m.
int32_t tpg_body_init(tpg_body_t *body,
                      const tpg_arm_t *arm,
                      const float *radii);

// Begins a control loop towards a target, which is given by the poses that solve it: one to TPG_GOALS `goals`, the nearest first.
// `body` and `policy` must stay where they are for as long as the loop is used. `settings` and `watch` may be NULL: the defaults.
//
// TPG_BAD_TARGET for no goal, too many, or one that is outside the joints' ranges or touches table or base. TPG_BAD_SENSOR as
// tpg_dodger_step. TPG_ARGUMENT for settings, sources or behaviours that are not accepted.
int32_t tpg_dodger_init(tpg_dodger_t *dodger,
                        const tpg_body_t *body,
                        const tpg_dodge_policy_t *policy,
                        const tpg_dodger_settings_t *settings,
                        const tpg_watch_t *watch,
                        const tpg_pose_t *goals,
                        size_t goal_count,
                        const tpg_pose_t *motors,
                        const tpg_ball_t *balls,
                        size_t ball_count);

// One step of a control loop: takes a reading of the motors and of up to TPG_BALLS `balls`, answers the move that goes to the motors
// before the next step. `balls` may be NULL where there are none.
//
// TPG_BAD_SENSOR for a motor outside its joint's range, more balls, or one that cannot be (see tpg_ball_t); TPG_STUCK for
// motors that are not where the moves led them; docs/sensors.md has the contract. With any other code than TPG_OK the move is
// zero, and the loop is as before: the next step with a good reading goes on. After TPG_STUCK it does once the motors are where
// the moves led them, or after tpg_dodger_resume.
int32_t tpg_dodger_step(tpg_dodger_t *dodger,
                        const tpg_pose_t *motors,
                        const tpg_ball_t *balls,
                        size_t count,
                        tpg_dodge_t *chosen);

// Starts to compare commanded with observed motion anew, from where the motors are: the way out of TPG_STUCK once its cause
// is removed. The search goes on as it is. TPG_BAD_SENSOR for a motor outside its joint's range.
int32_t tpg_dodger_resume(tpg_dodger_t *dodger,
                          const tpg_pose_t *motors);

// Joins a generated policy and a network. `arm`, `policy`, `sac` and `scratch` must stay where they are for as long as
// the hybrid is used; `scratch`, of as many words as tpg_sac_scratch says, is the hybrid's alone.
//
// TPG_ARGUMENT for settings that are not accepted: hand_back_after from 1, separation from 0 mm.
int32_t tpg_hybrid_init(tpg_hybrid_t *hybrid,
                        const tpg_arm_t *arm,
                        const tpg_policy_t *policy,
                        const tpg_sac_t *sac,
                        const tpg_settings_t *settings,
                        uint32_t *scratch,
                        size_t words);

// Begins a control loop towards a target: the graph drives, by the settings of the hybrid. `watch` may be NULL: the
// defaults. TPG_BAD_TARGET or TPG_BAD_SENSOR for an observation that cannot be.
int32_t tpg_switch_init(tpg_switch_t *switch_,
                        const tpg_hybrid_t *hybrid,
                        const tpg_watch_t *watch,
                        const tpg_observation_t *observation);

// One step of a control loop: takes a reading of the motors and the target (x, y, z in mm), answers what is seen and the
// action that goes to the motors before the next step.
//
// TPG_BAD_TARGET, TPG_BAD_SENSOR or TPG_STUCK where nothing may move; docs/sensors.md has the contract. The chosen move is
// zero then, the observation is not written, and the switch is as before: the next step with a good reading goes on. After
// TPG_STUCK it does once the motors are where the commands led them, or after tpg_switch_resume.
int32_t tpg_hybrid_step(tpg_hybrid_t *hybrid,
                        tpg_switch_t *switch_,
                        const tpg_pose_t *motors,
                        const float *target,
                        tpg_observation_t *observation,
                        tpg_chosen_t *chosen);

// Starts to compare commanded with observed motion anew, from where the motors are: the way out of TPG_STUCK once its cause
// is removed. The switch goes on as it is. TPG_BAD_SENSOR for a motor outside its joint's range.
int32_t tpg_switch_resume(tpg_switch_t *switch_,
                          const tpg_pose_t *motors);

// Gives the counts so far.
int32_t tpg_switch_counts(const tpg_switch_t *switch_, tpg_counts_t *counts);

// Empties a memo: before its first use, and after the arm that it was used with was initialised anew.
int32_t tpg_memo_init(tpg_memo_t *memo);

// Checks a model of `words` 32-bit words and borrows it: it must stay where it is and as it is, in flash say, for as long
// as `network` is used.
int32_t tpg_network_init(tpg_network_t *network,
                         const uint32_t *model,
                         size_t words);

// Gives the 32-bit words of scratch memory that a decision needs.
int32_t tpg_network_scratch(const tpg_network_t *network, size_t *words);

// Gives the count of numbers in a state.
int32_t tpg_network_inputs(const tpg_network_t *network, size_t *inputs);

// Gives the count of outputs of the network: values, or actions to choose from.
int32_t tpg_network_outputs(const tpg_network_t *network, size_t *outputs);

// The values that a network answers a state with. `scratch` is overwritten. TPG_LENGTH where `length` numbers of the state,
// `words` of scratch memory or `count` values are too few; TPG_ARGUMENT for a network that does not answer with values.
int32_t tpg_network_values(const tpg_network_t *network,
                           const float *state,
                           size_t length,
                           uint32_t *scratch,
                           size_t words,
                           float *values,
                           size_t count);

// The action that a network chooses in a state: the number of its greatest output, of equals the first. `scratch` is
// overwritten. TPG_LENGTH where `length` numbers of the state or `words` of scratch memory are too few; TPG_ARGUMENT for a
// network that does not choose.
int32_t tpg_network_choose(const tpg_network_t *network,
                           const float *state,
                           size_t length,
                           uint32_t *scratch,
                           size_t words,
                           uint16_t *action);

// Observes the arm at a pose, with the target's x, y, z in mm. It checks neither: a decision does.
int32_t tpg_observe(const tpg_arm_t *arm, const tpg_pose_t *pose, const float *target, tpg_observation_t *observation);

// Hand to target, mm.
int32_t tpg_observation_distance(const tpg_observation_t *observation, float *distance);

// Writes the values of `count` sources (TPG_SOURCE codes), one after another, into `state`: a generated policy's own
// structure, say. TPG_LENGTH where `length` floats are too few, TPG_ARGUMENT for an unknown source.
//
// `memo` is NULL, or keeps from call to call what depends on the target alone.
int32_t tpg_observation_state(const tpg_arm_t *arm,
                              const tpg_observation_t *observation,
                              tpg_memo_t *memo,
                              const uint8_t *sources,
                              size_t count,
                              float *state,
                              size_t length);

// The move that a generated policy decides for. TPG_BAD_TARGET or TPG_BAD_SENSOR, and a move of zero, for an observation
// that cannot be; docs/sensors.md has the contract. Stuck motors it cannot see: see tpg_watchdog_t.
//
// `memo` is NULL, or keeps from call to call what depends on the target alone.
int32_t tpg_policy_decide(const tpg_policy_t *policy,
                          const tpg_arm_t *arm,
                          const tpg_observation_t *observation,
                          tpg_memo_t *memo,
                          tpg_move_t *wanted);

// Checks a model of `words` 32-bit words and borrows it: it must stay where it is and as it is, in flash say, for as long
// as `sac` is used.
int32_t tpg_sac_init(tpg_sac_t *sac,
                     const uint32_t *model,
                     size_t words);

// Gives the 32-bit words of scratch memory that tpg_sac_decide needs.
int32_t tpg_sac_scratch(const tpg_sac_t *sac, size_t *words);

// The move that a network decides for. `scratch` is overwritten; TPG_LENGTH where `words` are too few. TPG_BAD_TARGET or
// TPG_BAD_SENSOR, and a move of zero, for an observation that cannot be; docs/sensors.md has the contract.
int32_t tpg_sac_decide(const tpg_sac_t *sac,
                       const tpg_arm_t *arm,
                       const tpg_observation_t *observation,
                       uint32_t *scratch,
                       size_t words,
                       tpg_move_t *wanted);

// Starts to watch an arm whose motors are at `motors`. `watch` may be NULL: the defaults. TPG_BAD_SENSOR for a motor outside its
// joint's range.
int32_t tpg_watchdog_init(tpg_watchdog_t *watchdog,
                          const tpg_arm_t *arm,
                          const tpg_watch_t *watch,
                          const tpg_pose_t *motors);

// Checks a reading of the motors and a target, x, y, z in mm: TPG_BAD_TARGET, TPG_BAD_SENSOR or TPG_STUCK where nothing may
// move.
int32_t tpg_watchdog_check(const tpg_watchdog_t *watchdog,
                           const tpg_pose_t *motors,
                           const float *target);

// Notes a move that goes to the motors, and the positions at which it was decided on.
int32_t tpg_watchdog_commanded(tpg_watchdog_t *watchdog, const tpg_pose_t *motors, const tpg_move_t *wanted);

// Starts to compare anew, from where the motors are: the way out of TPG_STUCK once its cause is removed. TPG_BAD_SENSOR for
// a motor outside its joint's range.
int32_t tpg_watchdog_resume(tpg_watchdog_t *watchdog,
                            const tpg_pose_t *motors);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TPG_RUNTIME_H */
