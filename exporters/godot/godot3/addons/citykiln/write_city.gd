# Copies chosen tiles of a run into a project and writes what Godot needs to import them: a file of import settings beside
# each tile, so that tile_import.gd runs on it, the choices (city.json), and a scene of all tiles with the sun of the run's
# time (city.tscn).
#
# Choices: "levels" (numbers), "tiles" (names), "layers" (names), "collision" (names of layers, of the finest chosen
# level), "pixel_error" (pixels by which a level may be wrong where it is shown).
extends Reference

const SETTINGS = """[remap]

importer="scene"
type="PackedScene"

[deps]

source_file="%s"

[params]

nodes/custom_script="%s"
materials/storage=0
meshes/ensure_tangents=false
animation/import=false
"""
# A clear day, as bright as in citykiln's preview.
const SKY = """
[sub_resource type="ProceduralSky" id=1]
sky_top_color = Color( 0.42, 0.54, 0.73, 1 )
sky_horizon_color = Color( 0.67, 0.76, 0.85, 1 )
ground_bottom_color = Color( 0.42, 0.4, 0.38, 1 )
ground_horizon_color = Color( 0.6, 0.66, 0.7, 1 )
sun_energy = 0.0

[sub_resource type="Environment" id=2]
background_mode = 2
background_sky = SubResource( 1 )
ambient_light_energy = 1.0
tonemap_mode = 3
tonemap_white = 6.0
"""
const LIGHTS = """
[node name="Sun" type="DirectionalLight" parent="."]
transform = %s
light_color = Color( 1, 0.93, 0.83, 1 )
light_energy = 2.5
shadow_enabled = true
directional_shadow_max_distance = 300.0

[node name="Sky" type="WorldEnvironment" parent="."]
environment = SubResource( 2 )
"""


# Returns an empty text, or one line that says what is wrong.
func write(run, target, choices):
	var problem = problem_of(run, choices)
	if problem != "":
		return problem
	var folder = Directory.new()
	if folder.make_dir_recursive(target) != OK:
		return "%s: the folder cannot be made" % target
	problem = write_text(target.plus_file("city.json"), to_json(choices))
	for file in chosen_files(run, choices):
		if problem == "":
			problem = copy_tile(folder, run.folder.plus_file(file["file"]), target.plus_file(file["file"].get_file()))
	if problem == "":
		problem = write_text(target.plus_file("city.tscn"), scene_text(run, target, choices))
	return problem


func problem_of(run, choices):
	if run.problem != "":
		return run.problem
	for tile in choices["tiles"]:
		if not tile in run.tiles:
			return "%s: has no tile %s; it has %s" % [run.folder, tile, PoolStringArray(run.tiles).join(", ")]
	for level in choices["levels"]:
		if level < 0 or level >= run.levels.size():
			return "%s: has no level %d; it has 0 to %d" % [run.folder, level, run.levels.size() - 1]
	for layer in choices["layers"] + choices["collision"]:
		if not layer in run.LAYERS:
			return "%s is not a layer; the layers are %s" % [layer, PoolStringArray(run.LAYERS).join(", ")]
	return "" if chosen_files(run, choices).size() > 0 else "no tiles are chosen"


func chosen_files(run, choices):
	var chosen = []
	for file in run.files:
		if run.name_of(file) in choices["tiles"] and int(file["level"]) in choices["levels"]:
			chosen.append(file)
	return chosen


func copy_tile(folder, from, to):
	var script = get_script().resource_path.get_base_dir().plus_file("tile_import.gd")
	if folder.copy(from, to) != OK:
		return "%s: cannot be copied to %s" % [from, to]
	return write_text(to + ".import", SETTINGS % [to, script])


func write_text(path, text):
	var file = File.new()
	if file.open(path, File.WRITE) != OK:
		return "%s: cannot be written" % path
	file.store_string(text)
	file.close()
	return ""


# A scene as text: it names files that Godot imports later.
func scene_text(run, target, choices):
	var chosen = chosen_files(run, choices)
	var is_day = run.to_sun != Vector3()
	var head = "[gd_scene load_steps=%d format=2]\n\n" % (chosen.size() + (4 if is_day else 2))
	head += "[ext_resource path=\"%s\" type=\"Script\" id=1]\n" % get_script().resource_path.get_base_dir().plus_file("city.gd")
	var nodes = "\n[node name=\"City\" type=\"Spatial\"]\nscript = ExtResource( 1 )\n"
	nodes += "errors_m = %s\npixel_error = %s\nattribution = %s\n" % [
		to_json(errors_of(run, choices)), choices["pixel_error"], to_json(PoolStringArray(run.attribution).join("; "))]
	for tile in choices["tiles"]:
		nodes += "\n[node name=\"%s\" type=\"Spatial\" parent=\".\"]\n" % tile
	var id = 1
	for file in chosen:
		id += 1
		var path = target.plus_file(file["file"].get_file())
		head += "[ext_resource path=\"%s\" type=\"PackedScene\" id=%d]\n" % [path, id]
		nodes += "\n[node name=\"L%d\" parent=\"%s\" instance=ExtResource( %d )]\n" % [file["level"], run.name_of(file), id]
	return head + SKY + nodes + LIGHTS % shining_from(run.to_sun) if is_day else head + nodes


# A light's placement as text of scenes.
func shining_from(to_sun):
	var light = Transform().looking_at(-to_sun, Vector3.UP)
	return "Transform(%s)" % var2str(light).trim_prefix("Transform(").trim_suffix(")")


# The measured errors of the chosen levels, finest first.
func errors_of(run, choices):
	var errors = []
	for level in choices["levels"]:
		errors.append(run.levels[level]["error_m"])
	return errors
