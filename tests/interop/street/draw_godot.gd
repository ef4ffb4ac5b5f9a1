# Runs inside Godot 3: draws a street of a city that the plugin wrote, lit as the plugin lights it. The environment variable
# JOB names a JSON file: `scene`, `eye`, `look` (metres, y up), `fov_deg` (vertical), `size`, `out`.
extends SceneTree


func _init():
	var file = File.new()
	file.open(OS.get_environment("JOB"), File.READ)
	var job = parse_json(file.get_as_text())
	var city = load(job["scene"]).instance()
	get_root().add_child(city)
	var camera = Camera.new()
	camera.near = 0.1
	camera.far = 6000
	camera.fov = job["fov_deg"]
	get_root().add_child(camera)
	camera.make_current()
	camera.look_at_from_position(vector(job["eye"]), vector(job["look"]), Vector3.UP)
	OS.window_size = Vector2(job["size"][0], job["size"][1])
	get_root().size = OS.window_size
	city.choose_levels()
	for i in 8:
		yield(self, "idle_frame")
	var image = get_root().get_texture().get_data()
	image.flip_y()
	image.save_png(job["out"])
	quit()


func vector(v):
	return Vector3(v[0], v[1], v[2])
