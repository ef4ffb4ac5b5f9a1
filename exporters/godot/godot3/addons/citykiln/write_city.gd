# Copies chosen tiles of a run into a project and writes what Godot needs to import them: a file of import settings beside
# each tile, so that tile_import.gd runs on it, the choices (city.json), and a scene of all tiles at the hour of the run
# (city.tscn).
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
# City sets the sun's direction and the colours of the sky, by the hour.
const SKY = """
[sub_resource type="ProceduralSky" id=1]
sun_energy = 0.0

[sub_resource type="Environment" id=2]
background_mode = 2
background_sky = SubResource( 1 )
tonemap_mode = 3
tonemap_white = 6.0
"""
const LIGHTS = """
[node name="Sun" type="DirectionalLight" parent="."]
shadow_enabled = true
directional_shadow_mode = 1
directional_shadow_max_distance = 120.0

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
	var head = "[gd_scene load_steps=%d format=2]\n\n" % (chosen.size() + 4)
	head += "[ext_resource path=\"%s\" type=\"Script\" id=1]\n" % get_script().resource_path.get_base_dir().plus_file("city.gd")
	var nodes = "\n[node name=\"City\" type=\"Spatial\"]\nscript = ExtResource( 1 )\n"
	nodes += "errors_m = %s\npixel_error = %s\nattribution = %s\n" % [
		to_json(errors_of(run, choices)), choices["pixel_error"], to_json(PoolStringArray(run.attribution).join("; "))]
	nodes += "date = \"%s\"\nhour = %f\nlongitude_deg = %f\nlatitude_deg = %f\n" % [
		run.date, run.hour, run.origin["lon_deg"], run.origin["lat_deg"]]
	for tile in choices["tiles"]:
		nodes += "\n[node name=\"%s\" type=\"Spatial\" parent=\".\"]\n" % tile
	var id = 1
	for file in chosen:
		id += 1
		var path = target.plus_file(file["file"].get_file())
		head += "[ext_resource path=\"%s\" type=\"PackedScene\" id=%d]\n" % [path, id]
		nodes += "\n[node name=\"L%d\" parent=\"%s\" instance=ExtResource( %d )]\n" % [file["level"], run.name_of(file), id]
	return head + SKY + nodes + LIGHTS


# The measured errors of the chosen levels, finest first.
func errors_of(run, choices):
	var errors = []
	for level in choices["levels"]:
		errors.append(run.levels[level]["error_m"])
	return errors
