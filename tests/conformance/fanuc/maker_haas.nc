(What a Haas has otherwise than a FANUC.)
(SOURCE Haas mill operator's manual 96-8000: G and M codes, macros; haascnc.com, conditional expressions)
(CONTROL haas)

(CASE MB-366 #5063 has the tool length in it, as #5043 has)
(SHEET [tools.1])
(SHEET length = 100.0)
(SIGNAL Z140)
%
O1
G90 G43 H1 G0 Z60.
G31 Z20. F100.
#100=#5063
#101=#5063-#5083
#102=#5043-#5083
M30
%
(EXPECT #100 = 140)
(EXPECT #101 = 40)
(EXPECT #102 = 40)

(CASE G43 moves nothing, nor does G49: the axis goes when it is named)
(SHEET [tools.1])
(SHEET length = 100.0)
(START Z = 300)
%
O1
G90 G43 H1
G0 X10.
Z50.
G49
X20.
M30
%
(EXPECT MOVE 1 X10 Z300)
(EXPECT MOVE 2 X10 Z150)
(EXPECT MOVE 3 X20 Z150)

(CASE G28 without axes takes them all home)
(START X = 10)
(START Z = 30)
%
O1
G28
M30
%
(EXPECT MOVES 2)
(EXPECT MOVE 2 X0 Y0 Z0)

(CASE G91 G53 is ignored with a word)
(CONTROL fanuc-16i)
(START X = 30)
%
O1
G91 G53 X10.
M30
%
(EXPECT MOVES 0)
(EXPECT WARNING PRB314 AT 5)

(CASE M97 calls blocks of its own program)
%
O1
#100=1
M97 P1000
#101=#100
M97 P1000 L3
M30
N1000 #100=#100*2
M99
%
(EXPECT #101 = 2)
(EXPECT #100 = 16)

(CASE M97 within M97, locals shared)
%
O1
#1=5
M97 P100
#101=#1
M30
N100 #1=#1+1
M97 P200
M99
N200 #1=#1*10
M99
%
(EXPECT #101 = 60)

(CASE M97 of a block that is not there)
%
O1
M97 P1000
M30
%
(EXPECT ALARM 78 AT 3)

(CASE M96 goes on at P while the input is off)
(SET #11008 = 1)
%
O1
M96 P10 Q9
#100=1
N10 M96 P20 Q8
#101=1
N20 M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 1)

(CASE G154 and G110 are the same systems, #14001 and #7001 their storage)
%
O1
#14001=5.
#14021=7.
G154 P1
G0 X0
#100=#4012
G111
X0
#101=#7021
M30
%
(EXPECT MOVE 1 X5)
(EXPECT MOVE 2 X7)
(EXPECT #100 = 154)
(EXPECT #101 = 7)

(CASE G103 and G187 and G255 change no figure)
%
O1
G103 P1
G187 P2 E0.05
G255
G0 X1.
M30
%
(EXPECT MOVES 1)
(EXPECT NO WARNING PRB304)

(CASE G47 engraves, which is not simulated)
%
O1
G47 E7.5 I0 J0.5 P0 R0.1 X2. Y2. Z-0.005 (TEXT)
M30
%
(EXPECT MOVES 0)
(EXPECT WARNING PRB304 AT 3)

(CASE MB-285 G04 P with a point is seconds, without it milliseconds)
%
O1
G04 P1.5
G04 P250
M30
%
(EXPECT MOVE 1 G4 T1.5)
(EXPECT MOVE 2 G4 T0.25)

(CASE an IF takes an assignment without THEN)
(CONTROL fanuc-16i fanuc-30i meldas)
%
O1
#1=2
IF [#1 EQ 2] #26=[#1+3]
IF [#1 EQ 3] #26=99
#100=#26
M30
%
(EXPECT #100 = 5)

(CASE an IF takes a call, or any block)
%
O1
#1=1
IF [#1 EQ 1] M98 P2
IF [#1 EQ 2] M98 P2
IF [#1 EQ 1] THEN G0 X7.
M30
O2
#100=#100+1
M99
%
(EXPECT #100 = 1)
(EXPECT MOVE 1 X7)

(CASE what is not 0 is true, a comparison is 1 or 0)
%
O1
#1=0.5
IF [#1] GOTO 10
#100=1
N10 IF [#2] GOTO 20
#101=1
N20 #102=[1 LT 2]+[2 LT 1]
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 1)
(EXPECT #102 = 1)

(CASE AND and OR in a condition)
%
O1
IF [[1 EQ 1] AND [2 EQ 2]] #100=1
IF [[1 EQ 2] OR [2 EQ 2]] #101=1
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 1)

(CASE a condition decides upon M99)
%
O1
#1=0
N10 #1=#1+1
[#1 LT 4] M99 P10
#100=#1
M30
%
(EXPECT #100 = 4)

(CASE MB-360 #10000 to #10999 are its common variables, #10100 is #100)
%
O1
#10000=1
#10200=2
#100=#10000+#10200
#10150=3
#101=#150
#500=4
#102=#10500
#103=#10999
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 3)
(EXPECT #102 = 4)
(EXPECT #103 = VACANT)

(CASE settings, parameters and elements of parameters come from the sheet)
(SET #20009 = 1)
(SET #30012 = 7)

(SET #30012.003 = 4.5)
%
O1
#100=#20009
#101=#20010
#102=#30012
#103=#30012.003
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 0)
(EXPECT #102 = 7)
(EXPECT #103 = 4.5)

(CASE a program writes no setting)
%
O1
#20009=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE #3026 is the tool in the spindle)
(SET #3026 = 3)
%
O1
#100=#3026
T5 M6
#101=#3026
T7
#102=#3026
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 5)
(EXPECT #102 = 5)

(CASE inputs and outputs by both numbers)
(SET #11003 = 1)
(SET #11200 = 1)
%
O1
#100=#1003
#101=#11200
#12002=1
#102=#1102
#12200=1
#103=#12200
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 1)
(EXPECT #102 = 1)
(EXPECT #103 = 1)

(CASE a suite waits for an input beyond #1015 that the sheet scripts)
(SHEET [[input]])
(SHEET number = 11017)
(SHEET from_code = "M69")
(SHEET [[input]])
(SHEET number = 11017)
(SHEET value = 0)
(SHEET from_code = "M59")
%
O1
#100=#11017
M69 P3
#3001=0
WH[#11017NE1]DO1
IF[#3001GT3000.]GOTO9
END1
#101=#11017
M59 P3
#102=#11017
M30
N9 #3000=1(PROBE SWITCH OFF FAILURE)
%
(EXPECT #100 = 0)
(EXPECT #101 = 1)
(EXPECT #102 = 0)

(CASE M79 is an alarm where no signal came, nothing where one did)
(SIGNAL X4)
(SIGNAL NONE)
%
O1
G31 M79 X10. F100.
#100=#5061
G31 M79 X20. F100.
#101=1
M30
%
(EXPECT ALARM 379 AT 7)
(EXPECT #100 = 4)
(EXPECT #101 = VACANT)

(CASE M78 is an alarm where one came)
(SIGNAL NONE)
(SIGNAL X14)
%
O1
G31 M78 X10. F100.
#100=1
G31 X20. M78
M30
%
(EXPECT ALARM 378 AT 7)
(EXPECT #100 = 1)

(CASE parameters, settings and their bits by the numbers of older controls)
(SET #20009 = 1)
(SET #30057 = 40)
(SET #30057.25 = 1)
%
O1
#100=#6009
#101=#6557
#6996=57
#102=#6998
#6997=3
#103=#6998
#6997=4
#104=#6998
#105=#30057.250
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 40)
(EXPECT #102 = 40)
(EXPECT #103 = 1)
(EXPECT #104 = 0)
(EXPECT #105 = 1)

(CASE the number of an element may be computed)
(SET #30012 = 7)
(SET #30012.003 = 4.5)
%
O1
#1=3
#100=#[30012+#1/1000]
#101=#[30010+2]
M30
%
(EXPECT #100 = 4.5)
(EXPECT #101 = 7)

(CASE data of tools one by one and of the tool that #8550 names)
(SHEET [tools.5])
(SHEET length = 100.0)
(SHEET radius = 4.0)
(SET #1605 = 3)
(SET #5405 = 12)
(SET #5705 = 9)
%
O1
#100=#8553
#8550=5
#101=#8551
#102=#8553
#103=#8555
#104=#8559
#105=#8562
#5505=30
#106=#8560
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 3)
(EXPECT #102 = 100)
(EXPECT #103 = 8)
(EXPECT #104 = 12)
(EXPECT #105 = 9)
(EXPECT #106 = 30)

(CASE the whole tool table and the machine's own counts can be read)
(SET #50005 = 4)
(SET #1064 = 12)
(SET #8510 = 7)
%
O1
#100=#50005
#52605=2
#101=#52605+#52604
#102=#1064+#1098+#1264+#3196
#103=#8510
#104=#13013+#9000+#9016
M30
%
(EXPECT #100 = 4)
(EXPECT #101 = 2)
(EXPECT #102 = 12)
(EXPECT #103 = 7)
(EXPECT #104 = 0)

(CASE macro calls nest nine deep)
(SOURCE Haas alarm 307: nine levels)
%
O1
#1=1
#100=0
G65 P2 A1
M30
O2
#100=#100+1
IF [#100 GE 9] GOTO 9
G65 P2 A1
N9 M99
%
(EXPECT #100 = 9)

(CASE G36 makes the point of the signal the zero of the axis, shifted by I)
(SIGNAL X12.5)
(SIGNAL X12.5)
%
O1
G91 G36 X20. F100.
#100=#5221
#101=#5041
G0 X-10.
G36 X20. I-2.
#102=#5221
#103=#5222
M30
%
(EXPECT #100 = 12.5)
(EXPECT #101 = 0)
(EXPECT #102 = 10.5)
(EXPECT #103 = 0)

(CASE G36 in a G154 system)
(SIGNAL Y-7.25)
%
O1
G154 P3
G91 G36 Y-20. F100.
#100=#14042
M30
%
(EXPECT #100 = -7.25)

(CASE G36 takes no tool length along)
(SHEET [tools.1])
(SHEET length = 100.0)
%
O1
G43 H1
G91 G36 X20. F100.
M30
%
(EXPECT ALARM 82 AT 6)

(CASE G136 makes the middle between its point and that of M75 the zero)
(SIGNAL X10)
(SIGNAL X-6)
%
O1
G91 G31 X20. F100. M75
G0 X-12.
G136 X-20.
#100=#5221
M30
%
(EXPECT #100 = 2)

(CASE settings 59 and 60 lead from the signal to the surface)
(SET #20059 = 3)
(SET #20060 = -3)
(SIGNAL X7)
(SIGNAL X-3)
(SIGNAL X7)
%
O1
G91 G31 X20. F100.
M75
G0 X-6.
G136 X-20.
#100=#5221
G0 X5.
G36 X20.
#101=#5221
M30
%
(EXPECT #100 = 2)
(EXPECT #101 = 10)

(CASE G35: diameter D is the way between two touches less the probe's width)
(SIGNAL Y-6)
(SIGNAL Y6)
(SET #20063 = 2)
(START Y = -20)
%
O1
G91 G31 Y18. F100. M75
G0 Y-5.
X30.
Y40.
X-30.
G35 Y-40. D4
#100=#2404
M30
%
(EXPECT #100 = 10)

(CASE G37: H is so long that a move to its Z ends where the signal came)
(SHEET [tools.1])
(SHEET length = 100.0)
(START Z = 300)
(SIGNAL Z140)
%
O1
#5223=5.
G43 H1
G37 Z10. F100.
#100=#2001
G43 H1
G0 Z10.
#101=#5023
M30
%
(EXPECT #100 = 125)
(EXPECT #101 = 140)

(CASE G37 needs the length offset that it sets)
%
O1
G37 Z0. F100.
M30
%
(EXPECT ALARM 81 AT 3)

(CASE five-axis modes are refused, not passed over)
%
O1
G0 X1.
G234 H1 Z10.
M30
%
(EXPECT ALARM 10 AT 4)
(EXPECT MOVES 1)

(CASE G254 is refused, G255 has nothing to end)
%
O1
G255
G0 X1.
G254
X2.
M30
%
(EXPECT ALARM 10 AT 5)
(EXPECT MOVES 1)

(CASE #4101 to #4126 are the last words by the numbers of macro arguments)
%
O1
#9=7.
G0 X1.3 Y-2.
G1 Z0.5 F250. I4. D#9
#100=#4124
#101=#4125
#102=#4126
#103=#4104
#104=#4107
#105=#4109
#106=#4101
G0 X2.
#107=#4124
#108=#4126
M30
%
(EXPECT #100 = 1.3)
(EXPECT #101 = -2)
(EXPECT #102 = 0.5)
(EXPECT #103 = 4)
(EXPECT #104 = 7)
(EXPECT #105 = 250)
(EXPECT #106 = 0)
(EXPECT #107 = 2)
(EXPECT #108 = 0.5)

(CASE a macro called by a code finds the words of its call there)
(SHEET [macro_calls])
(SHEET M165 = 9014)
%
O1
M165 D20. X-3. K1.5
M30
O9014
#100=#4107
#101=#4124
#102=#4106
M99
%
(EXPECT #100 = 20)
(EXPECT #101 = -3)
(EXPECT #102 = 1.5)

(CASE letters that are no arguments have no number)
%
O1
#100=#4127
M30
%
(EXPECT ALARM 115 AT 3)

(CASE S-77 F without a point counts 0.001 mm a minute, as the setting comes)
(SOURCE Haas, help with the decimal points: setting 77, F12 is 0.0012 inch a minute)
%
O1
G1 X10. F12
X20. F12.
M30
%
(EXPECT MOVE 1 X10 F0.012)
(EXPECT MOVE 2 X20 F12)

(CASE S-77 and 0.0001 inch a minute)
%
O1
G20
G1 X1. F12
#100=#4109
M30
%
(EXPECT #100 = 0.0012)

(CASE arguments D E F H M S T without a point are as written, others count increments)
(SOURCE Haas mill operator's manual 96-8000, macros: integer argument passing)
%
O1
G65 P2 D1 E2 F3000 H4 M5 S6 T7 Q8
M30
O2
#101=#7
#102=#8
#103=#9
#104=#11
#105=#13
#106=#19
#107=#20
#108=#17
M99
%
(EXPECT #101 = 1)
(EXPECT #102 = 2)
(EXPECT #103 = 3000)
(EXPECT #104 = 4)
(EXPECT #105 = 5)
(EXPECT #106 = 6)
(EXPECT #107 = 7)
(EXPECT #108 = 0.008)

(CASE G10 L12 and L13 enter diameters, as D shows them)
(SOURCE Haas mill operator's manual 96-8000, G10: L12 is the diameter of a tool)
%
O1
G90 G10 L12 P5 R3.
G10 L13 P5 R0.05
#101=#2405
#102=#2605
G91 G10 L12 P5 R-1.
#103=#2405
G10 L10 P5 R100.
G90 G10 L10 P5 R100.
#104=#2005
M30
%
(EXPECT #101 = 3)
(EXPECT #102 = 0.05)
(EXPECT #103 = 2)
(EXPECT #104 = 100)

(CASE DPRNT needs no POPEN, the line is always open)
%
O1
DPRNT[A]
M30
%
(EXPECT NO WARNING PRB308)

(CASE P of G51 is the factor, with a point or without)
%
O1
G90 G54 G00 X0. Y0.
G51 X1. Y1. P2.
X3.
#100=#5021
G50
G51 X1. Y1. P3
X3.
#101=#5021
G51 X1. Y1. P0.5
X3.
#102=#5021
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 7)
(EXPECT #102 = 2)

(CASE G73 with I J K: each cut is less by J, down to K)
(SOURCE Haas mill operator's manual 96-8000, G73)
(PARAMETER 5114 = 0.1)
%
O1
G21 G90 G54 G00 X0. Y0. Z10.
G99 G73 Z-1. R1. I0.8 J0.3 K0.4 F100.
G80
M30
%
(EXPECT MOVE 3 X0 Y0 Z0.2)
(EXPECT MOVE 5 X0 Y0 Z-0.3)
(EXPECT MOVE 7 X0 Y0 Z-0.7)
(EXPECT MOVE 9 X0 Y0 Z-1)

(CASE codes of FANUC that a Haas mill has not)
(SOURCE Haas mill operator's manual 2017, lists of G codes)
%
O1
G90 G54 G00 X1.
G54.1 P7
M30
%
(EXPECT ALARM 10 AT 5)

(CASE functions of FANUC that a Haas has not)
%
O1
#101=FIX[1.7]
#100=FUP[1.2]
M30
%
(EXPECT #101 = 1)
(EXPECT ALARM 113 AT 4)

(CASE codes of a Haas that are passed over)
%
O1
G77 Z-1. R-1.6 Q0.1 F10.
G174 X1. Y1. Z1. F10.
G161 X1. Y1. Z1. E1. F10.
G00 X1.
M30
%
(EXPECT MOVES 1)
(EXPECT WARNING PRB304 AT 3)

(CASE M109: the operator's keys, one for each prompt)
(SOURCE Haas mill operator's manual 2017, M109)
(SETTING keys = "3Y")
%
O1
N1 #501=0
N5 M109 P501 (1,2,3)
IF [ #10501 EQ 0 ] GOTO5
IF [ #10501 EQ 51 ] GOTO30
GOTO1
N30 #101=#501
M109 P10549
#102=#549
M30
%
(EXPECT #101 = 51)
(EXPECT #102 = 89)
(EXPECT STOP "1,2,3")

(CASE M109 P is one of fifty variables)
(SETTING keys = "Y")
%
O1
M109 P550
M30
%
(EXPECT ALARM 115 AT 4)

(CASE M109 needs P)
%
O1
M109
M30
%
(EXPECT ALARM 5 AT 3)

(CASE G154 and G10 L20 have P1 to P99)
%
O1
G10 L20 P99 X5.
G90 G154 P99 G00 X0
#100=#5021
G154 P100
M30
%
(EXPECT ALARM 30 AT 6)

(CASE G10 L20 has no P100)
%
O1
G10 L20 P100 X5.
M30
%
(EXPECT ALARM 31 AT 3)

(CASE G83 with J and no K would come to nothing)
%
O1
G21 G90 G54 G00 Z10.
G83 Z-9. R1. I1. J0.6 F100.
M30
%
(EXPECT ALARM 45)

(CASE P of M98 is a number alone, L says how often)
(SOURCE mill operator's manual NGC 2017, M98: O40010 with M98 P40011)
%
O1
M98 P40011
M30
O0011
#100=#100+1
M99
%
(EXPECT ALARM 78 AT 4)
(EXPECT #100 = VACANT)

(CASE a program of five digits is called)
%
O1
#100=0
#101=0
M98 P40011 L2
M30
O0011
#100=#100+1
M99
O40011
#101=#101+1
M99
%
(EXPECT #100 = 0)
(EXPECT #101 = 2)

(CASE a computed jump reaches N0)
(SOURCE the same manual, computed branch)
%
O1
#1=0
#100=0
GOTO#1
#100=1
N0 #101=2
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 2)

(CASE and so does one to a number that is written; below 0 is nothing)
%
O1
#100=0
GOTO0
#100=1
N0 #101=2
GOTO-1
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 2)
(EXPECT ALARM 128 AT 7)

(CASE numbers of nine digits, and the sign of a Next Generation Control)
(SOURCE the same manual, formatted output; next generation control identifier)
%
O1
#100=123.456789
#101=#6198
#102=#6199
M30
%
(EXPECT #100 = 123.456789)
(EXPECT #101 = 1000000)
(EXPECT #102 = 0)

(CASE GOTO behind words jumps when they are done)
(SOURCE the same manual, unconditional branch; conditional branch)
%
O1
#100=0
G90 G54 G0 X1. GOTO 20
#100=1
N20 Y2.
M30
%
(EXPECT #100 = 0)
(EXPECT MOVES 2)
(EXPECT MOVE 1 X1 Y0)
(EXPECT MOVE 2 X1 Y2)

(CASE a condition behind words rules what follows it, not them)
%
O1
#1=1
#100=0
G90 G54 G0 X1. [#1EQ1] M99 P5
#100=1
N5 Y2. [#1EQ2] M99 P7
#100=#100+2
N7 M30
%
(EXPECT #100 = 2)
(EXPECT MOVES 2)
(EXPECT MOVE 2 X1 Y2)

(CASE no other control takes them, and nothing moves)
(CONTROL fanuc-16i)
%
O1
X1. GOTO 20
N20 M30
%
(EXPECT ALARM 127 AT 4)
(EXPECT MOVES 0)

(CASE nor a condition)
(CONTROL fanuc-16i)
%
O1
G0 X1. [#1EQ#0] M99 P20
N20 M30
%
(EXPECT ALARM 9 AT 4)
(EXPECT MOVES 0)

(CASE a condition that does not hold rules all that is left of the block)
(SOURCE the same manual, conditional execution: the rest of the block is ignored)
%
O1
#1=1
#100=0
G90 G54 G0 X5. [#1EQ2] X2. [#1EQ1] M99 P7
#100=#100+1
[#1EQ1] X3. [#1EQ1] X4. GOTO 7
#100=#100+2
N7 M30
%
(EXPECT #100 = 1)
(EXPECT MOVES 3)
(EXPECT MOVE 1 X5 Y0)
(EXPECT MOVE 2 X3 Y0)
(EXPECT MOVE 3 X4 Y0)

(CASE G73 with Q and K returns to R whenever it is K deeper)
(SOURCE Haas mill operator's manual 96-8000, G73)
(PARAMETER 5114 = 0.1)
(PARAMETER 5115 = 0.3)
%
O1
G21 G90 G54 G00 X0. Y0. Z10.
G99 G73 Z-9. R1. Q2. K4. F100.
G80
M30
%
(EXPECT MOVE 3 X0 Y0 Z-1)
(EXPECT MOVE 4 X0 Y0 Z-0.9)
(EXPECT MOVE 5 X0 Y0 Z-3)
(EXPECT MOVE 6 X0 Y0 Z1)
(EXPECT MOVE 7 X0 Y0 Z-2.7)
(EXPECT MOVE 8 X0 Y0 Z-5)
(EXPECT MOVE 9 X0 Y0 Z-4.9)
(EXPECT MOVE 10 X0 Y0 Z-7)
(EXPECT MOVE 11 X0 Y0 Z1)
(EXPECT MOVE 12 X0 Y0 Z-6.7)
(EXPECT MOVE 13 X0 Y0 Z-9)
(EXPECT MOVE 14 X0 Y0 Z1)
(EXPECT MOVES 14)

(CASE G76 steps aside by I and J where there is no Q)
(SOURCE Haas mill operator's manual 96-8000, shift of the boring cycles)
%
O1
G21 G90 G54 G00 X0. Y0. Z10.
G99 G76 X10. Y5. Z-5. R2. I1. J0.5 F100.
X20. Q0.3
G80
M30
%
(EXPECT MOVE 4 X10 Y5 Z-5)
(EXPECT MOVE 5 X11 Y5.5 Z-5)
(EXPECT MOVE 6 X11 Y5.5 Z2)
(EXPECT MOVE 7 X10 Y5 Z2)
(EXPECT MOVE 11 X20.3 Y5 Z-5)

(CASE it has no G11, and what that would end does not begin)
%
O1
G10 L50
N5114 R500
G11
M30
%
(EXPECT ALARM 31 AT 3)

(CASE G10 L2 P0 is G52, which G52 changes and #5201 shows)
(SOURCE Haas mill operator's manual, G10 and macro variables #5201 to #5206)
%
O1
G21 G54
G10 L2 P0 X1. Y2.
#100=#5201
G91 G10 L2 P0 Y.5
G90
#101=#5202
G52 X0 Y0
G0 X0 Y0
#102=#5021
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2.5)
(EXPECT #102 = 0)

(CASE G136 without M75 before it is told)
(SIGNAL X7)
%
O1
G21 G90 G54 G00 X0 Y0
G136 X10. F100.
M30
%
(EXPECT WARNING PRB334)

(CASE G20 and G21 say what setting 9 has to be)
(SOURCE Haas mill operator's manual, NGC 2017: G20 and G21)
(SET #20009 = 1)
%
O1
G21
X1.
G20
M30
%
(EXPECT MOVE 1 X1)
(EXPECT ALARM 10 AT 7)

(CASE G21 where setting 9 is inch)
(SET #20009 = 0)
%
O1
G20 X1.
G21
M30
%
(EXPECT MOVE 1 X25.4)
(EXPECT ALARM 10 AT 5)

(CASE where no sheet says how setting 9 is, the first of both codes does)
%
O1
G20 X1.
#100=#20009
G20 X2.
G21
M30
%
(EXPECT MOVE 2 X50.8)
(EXPECT #100 = 0)
(EXPECT ALARM 10 AT 6)

(CASE also one that says what was in force anyway)
%
O1
G21 X1.
G20
M30
%
(EXPECT ALARM 10 AT 4)

(CASE #7001 to #7386 are G154 P1 to P20, and #7501 and on tell of pallets: manual 96-8000 p. 113, 96-0012 p. 25)
%
O1
#7501=3.
#7806=2.
#7381=4.
#100=#14501
#101=#14381
#102=#7501+#7806
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 4)
(EXPECT #102 = 5)

(CASE #7401 is no variable of a Haas)
%
O1
#7401=1.
M30
%
(EXPECT ALARM 115 AT 3)
