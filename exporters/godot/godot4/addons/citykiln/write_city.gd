# Copies chosen tiles of a run into a project and writes what Godot needs to import them: a file of import settings beside
# each tile, so that tile_import.gd runs on it, the choices (city.json), and a scene of all tiles (city.tscn).
#
# Choices: "levels" (numbers), "tiles" (names), "layers" (names), "collision" (names of layers, of the finest chosen
# level), "pixel_error" (pixels by which a level may be wrong where it is shown), "screen_px" and "fov_deg" (rows and
# vertical field of view of the screen that this is true for).
@tool
extends RefCounted

const Run = preload("run.gd")

# Compression would move vertices by up to half a 65,536th of a tile, and levels are made already.
const SETTINGS := """[remap]

importer="scene"
type="PackedScene"

[deps]

source_file="%s"

[params]

import_script/path="%s"
meshes/generate_lods=false
meshes/force_disable_compression=true
animation/import=false
"""


# Returns an empty text, or one line that says what is wrong.
func write(run: Run, target: String, choices: Dictionary) -> String:
	var problem := problem_of(run, choices)
	if problem != "":
		return problem
	if DirAccess.make_dir_recursive_absolute(target) != OK:
		return "%s: the folder cannot be made" % target
	choices["errors_m"] = errors_of(run, choices)
	choices["tile_m"] = run.tile_m
	problem = write_text(target.path_join("city.json"), JSON.stringify(choices))
	for file: Dictionary in chosen_files(run, choices):
		if problem == "":
			var path: String = file["file"]
			problem = copy_tile(run.folder.path_join(path), target.path_join(path.get_file()))
	if problem == "":
		problem = write_text(target.path_join("city.tscn"), scene_text(run, target, choices))
	return problem


func problem_of(run: Run, choices: Dictionary) -> String:
	if run.problem != "":
		return run.problem
	for tile: String in choices["tiles"]:
		if not tile in run.tiles:
			return "%s: has no tile %s; it has %s" % [run.folder, tile, ", ".join(run.tiles)]
	for level: int in choices["levels"]:
		if level < 0 or level >= run.levels.size():
			return "%s: has no level %d; it has 0 to %d" % [run.folder, level, run.levels.size() - 1]
	for layer: String in choices["layers"] + choices["collision"]:
		if not layer in Run.LAYERS:
			return "%s is not a layer; the layers are %s" % [layer, ", ".join(Run.LAYERS)]
	return "" if chosen_files(run, choices).size() > 0 else "no tiles are chosen"


func chosen_files(run: Run, choices: Dictionary) -> Array:
	return run.files.filter(func(file: Dictionary) -> bool:
		return Run.name_of(file) in choices["tiles"] and int(file["level"]) in choices["levels"])


func copy_tile(from: String, to: String) -> String:
	if DirAccess.copy_absolute(from, to) != OK:
		return "%s: cannot be copied to %s" % [from, to]
	return write_text(to + ".import", SETTINGS % [to, beside("tile_import.gd")])


func beside(file_name: String) -> String:
	var here: Script = get_script()
	return here.resource_path.get_base_dir().path_join(file_name)


func write_text(path: String, text: String) -> String:
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		return "%s: cannot be written" % path
	file.store_string(text)
	return ""


# A scene as text: it names files that Godot imports later.
func scene_text(run: Run, target: String, choices: Dictionary) -> String:
	var chosen := chosen_files(run, choices)
	var head := "[gd_scene load_steps=%d format=3]\n\n" % (chosen.size() + 1)
	var nodes := "\n[node name=\"City\" type=\"Node3D\"]\nmetadata/attribution = %s\n" % JSON.stringify("; ".join(run.attribution))
	for tile: String in choices["tiles"]:
		nodes += "\n[node name=\"%s\" type=\"Node3D\" parent=\".\"]\n" % tile
	for i in chosen.size():
		var file: Dictionary = chosen[i]
		var path: String = file["file"]
		head += "[ext_resource type=\"PackedScene\" path=\"%s\" id=\"%d\"]\n" % [target.path_join(path.get_file()), i + 1]
		nodes += "\n[node name=\"L%d\" parent=\"%s\" instance=ExtResource(\"%d\")]\n" % [file["level"], Run.name_of(file), i + 1]
	return head + nodes


# The measured errors of the chosen levels, finest first.
func errors_of(run: Run, choices: Dictionary) -> Array:
	return choices["levels"].map(func(level: int) -> float: return run.levels[level]["error_m"])
