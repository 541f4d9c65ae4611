" Written by scripts/editor_grammars from the program's tables.
if exists("b:current_syntax")
  finish
endif

syn match mansardSymbol /\<[A-Z][A-Z0-9_]\+\>/
syn match mansardRule /\%([-+*/<>=&|!(,:]\s*\)\@<!\<\h\w*\ze\%(([^()]*)\)\=\%(\[[^][]*\]\)\=\s*\%(:[^:{}|\"]*\)\=->/
syn match mansardBlock /\<\h\w*\ze\s*{/
syn match mansardOperation /\<\%(inner_rectangle\|cylinder\|material\|occluder\|chamfer\|detrude\|extrude\|setback\|texture\|upright\|center\|insert\|mirror\|offset\|repeat\|report\|shapeL\|shapeO\|shapeU\|sphere\|subdiv\|align\|color\|label\|pivot\|print\|split\|stain\|taper\|best\|comp\|cone\|fail\|quad\|roof\|snap\|box\|cut\|set\|uv\|r\|s\|t\)\ze\s*[({]/
syn match mansardFunction /\<\%(Shape\.visible\|group\.count\|group\.best\|group\.rank\|Shape\.occ\|group\.all\|group\.any\|group\.max\|group\.min\|group\.sum\|overlaps\|reported\|nearest\|touches\|choose\|inside\|normal\|atan2\|clamp\|floor\|round\|acos\|asin\|atan\|attr\|ceil\|find\|made\|rand\|sqrt\|abs\|cos\|exp\|len\|log\|max\|min\|mod\|num\|pow\|sin\|str\|tan\)\ze\s*(/
syn match mansardLabel /\<\%(horizontal\|sidefaces\|vertical\|vertices\|facades\|outside\|parapet\|slanted\|border\|bottom\|corner\|fascia\|inside\|reveal\|soffit\|street\|valley\|cheek\|court\|edges\|faces\|front\|gable\|inner\|lower\|party\|ridge\|right\|shape\|slope\|strip\|upper\|back\|eave\|kept\|left\|main\|rake\|rest\|side\|all\|cut\|hip\|top\)\ze\s*:\%(:\)\@!/
syn match mansardArgument /\<\%(parapet_width\|break_height\|break_inset\|upper_pitch\|thickness\|tolerance\|distance\|overhang\|selector\|variable\|clipped\|corners\|message\|parapet\|across\|figure\|gables\|height\|planes\|color\|depth\|edges\|front\|hides\|label\|pitch\|ridge\|right\|score\|sides\|tooth\|value\|verge\|axes\|axis\|back\|file\|hips\|kind\|left\|mesh\|mode\|name\|rate\|size\|turn\|fit\|key\|to\|up\|u\|v\|x\|y\|z\)\ze\s*=\%(=\)\@!/
syn match mansardAttribute /\<\%(corner\.right\|corner\.left\|split\.count\|split\.index\|split\.round\|comp\.count\|comp\.index\|comp\.name\|scope\.sx\|scope\.sy\|scope\.sz\|scope\.tx\|scope\.ty\|scope\.tz\|scope\.D\|scope\.H\|scope\.W\|scope\.x\|scope\.y\|scope\.z\)\>/
syn match mansardAttribute /\<\%(is_rectangle\|elevation\|is_convex\|is_planar\|perimeter\|inradius\|facing\|symbol\|volume\|edges\|index\|level\|slope\|area\|seed\|D\|H\|W\)\>\%(\s*[:(=]\)\@!/
syn match mansardStyle /\<\h\w*\ze\s*::/
syn match mansardAnnotation /@\%(choice\|hidden\|color\|group\|label\|range\|stage\|seed\|unit\|per\)\>/
syn match mansardArrow /->/
syn match mansardNumber /\%(\w\|\.\)\@1<!\%(\d\+\.\=\d*\|\.\d\+\)\%([eE][+-]\=\d\+\)\=\%(r\>\|%\)\=/
syn keyword mansardInput BUILDING_HEIGHT BUILDING_LEVELS BUILDING_NAME BUILDING_USE
syn keyword mansardControl if then else super fits
syn keyword mansardConstant true false NIL
syn keyword mansardDeclaration import var def abstract final override start replace remove per
syn keyword mansardDeclaration style class nextgroup=mansardStyleName skipwhite
syn match mansardStyleName /\h\w*/ contained
syn match mansardEscape /\\\%(["\\]\|u\x\{4}\)/ contained
syn region mansardString start=/"/ skip=/\\./ end=/"\|$/ contains=mansardEscape
syn match mansardComment /\/\/.*/ contains=@Spell
syn match mansardDoc /^\s*\/\/\/.*/ contains=@Spell
syn region mansardComment start=/\/\*/ end=/\*\// contains=mansardComment,@Spell

hi def link mansardSymbol Constant
hi def link mansardRule Function
hi def link mansardBlock Structure
hi def link mansardOperation Statement
hi def link mansardFunction Function
hi def link mansardLabel Label
hi def link mansardArgument Identifier
hi def link mansardAttribute Special
hi def link mansardStyle Type
hi def link mansardStyleName Type
hi def link mansardAnnotation PreProc
hi def link mansardArrow Operator
hi def link mansardNumber Number
hi def link mansardInput Special
hi def link mansardControl Conditional
hi def link mansardConstant Boolean
hi def link mansardDeclaration Keyword
hi def link mansardEscape SpecialChar
hi def link mansardString String
hi def link mansardComment Comment
hi def link mansardDoc SpecialComment

let b:current_syntax = "mansard"
