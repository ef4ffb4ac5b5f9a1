# The dock: choose a run's folder, then levels, tiles, layers and collision, then import.
tool
extends VBoxContainer

const Run = preload("run.gd")
const WriteCity = preload("write_city.gd")

# the editor's file system
var files
var run
var folder = LineEdit.new()
var target = LineEdit.new()
var pixel_error = SpinBox.new()
var levels = ItemList.new()
var tiles = ItemList.new()
var layers = ItemList.new()
var collision = ItemList.new()
var message = Label.new()
var dialog = FileDialog.new()


func _init():
	name = "citykiln"
	add_row("Run", folder)
	add_button("Choose the run's folder", "choose_folder")
	add_row("Into", target)
	target.text = "res://city"
	for list in [["Levels", levels], ["Tiles", tiles], ["Layers", layers], ["Collision", collision]]:
		list[1].select_mode = ItemList.SELECT_MULTI
		list[1].rect_min_size = Vector2(0, 90)
		add_row(list[0], list[1])
	pixel_error.min_value = 0.5
	pixel_error.step = 0.5
	pixel_error.value = 2
	add_row("Error in pixels", pixel_error)
	add_button("Import", "import_run")
	message.autowrap = true
	add_child(message)
	dialog.mode = FileDialog.MODE_OPEN_DIR
	dialog.access = FileDialog.ACCESS_FILESYSTEM
	dialog.connect("dir_selected", self, "read_run")
	add_child(dialog)


func add_row(text, control):
	var label = Label.new()
	label.text = text
	add_child(label)
	add_child(control)


func add_button(text, method):
	var button = Button.new()
	button.text = text
	button.connect("pressed", self, method)
	add_child(button)


func choose_folder():
	dialog.popup_centered_ratio()


func read_run(of_folder):
	folder.text = of_folder
	run = Run.new().read(of_folder)
	message.text = run.problem
	fill(levels, range(run.levels.size()), true)
	for i in run.levels.size():
		levels.set_item_text(i, "L%d: %s m" % [i, run.levels[i]["tolerance_m"]])
	fill(tiles, run.tiles, true)
	fill(layers, run.LAYERS, true)
	fill(collision, run.LAYERS, false)


func fill(list, names, selected):
	list.clear()
	for i in names.size():
		list.add_item(str(names[i]))
		if selected:
			list.select(i, false)


func chosen(list, names):
	var found = []
	for i in list.get_selected_items():
		found.append(names[i])
	return found


func import_run():
	if run == null or run.folder != folder.text:
		read_run(folder.text)
	if run.problem != "":
		return
	message.text = WriteCity.new().write(run, target.text, {"levels": chosen(levels, range(run.levels.size())),
		"tiles": chosen(tiles, run.tiles), "layers": chosen(layers, run.LAYERS),
		"collision": chosen(collision, run.LAYERS), "pixel_error": pixel_error.value})
	if message.text == "":
		message.text = "Importing; then open %s" % target.text.plus_file("city.tscn")
		files.scan()
