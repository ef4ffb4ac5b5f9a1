# The dock: choose a run's folder, then levels, tiles, layers and collision, then import.
@tool
extends VBoxContainer

const Run = preload("run.gd")
const WriteCity = preload("write_city.gd")

# the editor's file system
var files: EditorFileSystem
var run: Run
var folder := LineEdit.new()
var target := LineEdit.new()
var pixel_error := SpinBox.new()
var levels := ItemList.new()
var tiles := ItemList.new()
var layers := ItemList.new()
var collision := ItemList.new()
var message := Label.new()
var dialog := FileDialog.new()


func _init() -> void:
	name = "citykiln"
	add_row("Run", folder)
	add_button("Choose the run's folder", func() -> void: dialog.popup_centered_ratio())
	add_row("Into", target)
	target.text = "res://city"
	add_list("Levels", levels)
	add_list("Tiles", tiles)
	add_list("Layers", layers)
	add_list("Collision", collision)
	pixel_error.min_value = 0.5
	pixel_error.step = 0.5
	pixel_error.value = 2
	add_row("Error in pixels", pixel_error)
	add_button("Import", import_run)
	message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	add_child(message)
	dialog.file_mode = FileDialog.FILE_MODE_OPEN_DIR
	dialog.access = FileDialog.ACCESS_FILESYSTEM
	dialog.dir_selected.connect(read_run)
	add_child(dialog)


func add_row(text: String, control: Control) -> void:
	var label := Label.new()
	label.text = text
	add_child(label)
	add_child(control)


func add_list(text: String, list: ItemList) -> void:
	list.select_mode = ItemList.SELECT_MULTI
	list.custom_minimum_size = Vector2(0, 90)
	add_row(text, list)


func add_button(text: String, pressed: Callable) -> void:
	var button := Button.new()
	button.text = text
	button.pressed.connect(pressed)
	add_child(button)


func read_run(of_folder: String) -> void:
	folder.text = of_folder
	run = Run.new()
	run.read(of_folder)
	message.text = run.problem
	fill(levels, range(run.levels.size()), true)
	for i in run.levels.size():
		levels.set_item_text(i, "L%d: %s m" % [i, run.levels[i]["tolerance_m"]])
	fill(tiles, run.tiles, true)
	fill(layers, Run.LAYERS, true)
	fill(collision, Run.LAYERS, false)


func fill(list: ItemList, names: Array, selected: bool) -> void:
	list.clear()
	for i in names.size():
		list.add_item(str(names[i]))
		if selected:
			list.select(i, false)


func chosen(list: ItemList, names: Array) -> Array:
	return Array(list.get_selected_items()).map(func(i: int) -> Variant: return names[i])


func import_run() -> void:
	if run == null or run.folder != folder.text:
		read_run(folder.text)
	if run.problem != "":
		return
	message.text = WriteCity.new().write(run, target.text, {"levels": chosen(levels, range(run.levels.size())),
		"tiles": chosen(tiles, run.tiles), "layers": chosen(layers, Run.LAYERS),
		"collision": chosen(collision, Run.LAYERS), "pixel_error": pixel_error.value,
		"screen_px": 1080.0, "fov_deg": 75.0})
	if message.text == "":
		message.text = "Importing; then open %s" % target.text.path_join("city.tscn")
		files.scan()
