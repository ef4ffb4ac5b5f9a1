# Someone who walks through a city whose ground, roads and buildings have collision shapes: W A S D or arrows, the mouse
# looks around. Add the script to a KinematicBody; it makes its capsule and its camera. Others steer it by `ahead` and
# `aside`.
extends KinematicBody

export var speed_m_s = 4.0
export var eye_m = 1.7
# Steps up to this height are walked up.
export var step_m = 0.5
export var mouse_turns_deg = 0.15

const RADIUS_M = 0.3
const GRAVITY = Vector3(0, -9.8, 0)

# -1 to 1: what is asked besides keys
var ahead = 0.0
var aside = 0.0
var falling = Vector3()
var camera = Camera.new()


func _ready():
	var shape = CollisionShape.new()
	shape.shape = CapsuleShape.new()
	shape.shape.radius = RADIUS_M
	# the capsule ends a step above the feet, so that it does not meet kerbs and low steps
	shape.shape.height = eye_m - step_m - RADIUS_M
	shape.rotation_degrees = Vector3(90, 0, 0)
	shape.translation.y = step_m + RADIUS_M + shape.shape.height / 2
	add_child(shape)
	camera.translation.y = eye_m
	camera.near = 0.1
	camera.far = 6000
	add_child(camera)
	camera.make_current()


func _input(event):
	if event is InputEventMouseMotion and Input.get_mouse_mode() == Input.MOUSE_MODE_CAPTURED:
		rotation_degrees.y -= event.relative.x * mouse_turns_deg
		camera.rotation_degrees.x = clamp(camera.rotation_degrees.x - event.relative.y * mouse_turns_deg, -85, 85)


func _physics_process(delta):
	var forward = ahead + pressed(KEY_W, KEY_UP) - pressed(KEY_S, KEY_DOWN)
	var right = aside + pressed(KEY_D, KEY_RIGHT) - pressed(KEY_A, KEY_LEFT)
	var along = (global_transform.basis.x * right - global_transform.basis.z * forward) * speed_m_s
	move_and_slide(along, Vector3.UP)
	stand(delta)


func pressed(one, other):
	return 1.0 if Input.is_key_pressed(one) or Input.is_key_pressed(other) else 0.0


# Keeps the feet on the ground: up steps at once, down by falling. Nothing moves where no ground is below.
func stand(delta):
	var from = global_transform.origin + Vector3(0, step_m + RADIUS_M, 0)
	var ground = get_world().direct_space_state.intersect_ray(from, from - Vector3(0, 1000, 0), [self])
	if ground.empty():
		return
	falling += GRAVITY * delta
	var height = max(ground["position"].y, global_transform.origin.y + falling.y * delta)
	if height == ground["position"].y:
		falling = Vector3()
	global_transform.origin.y = height
